# Installs what is missing on Debian 12; to be sourced.  Nothing is called when nothing is missing.
#
#   g31_install_packages LOGFILE    apt's own words go to LOGFILE, and to the screen when it fails
#   g31_build PRESET [-DNAME=VALUE...] [TARGET...]
#                                   configures quietly and builds
#   g31_build_with_progress PRESET LOGFILE [TARGET...]
#                                   the same; its words go to LOGFILE, how far it is to standard error

G31_PACKAGES=(
  g++ cmake ninja-build python3 python3-jsonschema
  libeigen3-dev libfmt-dev libcli11-dev nlohmann-json3-dev libtomlplusplus-dev
  libassimp-dev zlib1g-dev libfcl-dev libccd-dev libmeshoptimizer-dev libserialport-dev libcpp-httplib-dev libtbb-dev nettle-dev libocct-data-exchange-dev libboost-math-dev
  libgtest-dev libgmock-dev libbenchmark-dev
)
# The script of report pages is bundled by node; one that came from elsewhere than Debian will do.
command -v npm >/dev/null || G31_PACKAGES+=(nodejs npm)

g31_missing_packages() {
  local installed package
  # dpkg-query fails when one of them is unknown to it; the others are listed all the same.
  installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "${G31_PACKAGES[@]}" 2>/dev/null || true)
  for package in "${G31_PACKAGES[@]}"; do
    if ! grep -qxF "$package installed" <<<"$installed"; then
      echo "$package"
    fi
  done
}

g31_install_packages() {
  local log=$1 missing by_hand as_root=()
  mapfile -t missing < <(g31_missing_packages)
  if [ "${#missing[@]}" -eq 0 ]; then
    return 0
  fi
  by_hand="apt-get update && apt-get install -y --no-install-recommends ${missing[*]}"
  if ! command -v apt-get >/dev/null; then
    echo "g31 is built on Debian 12; apt-get is not here, and these of its packages are missing: ${missing[*]}" >&2
    return 1
  fi
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "These packages are missing, and neither root nor sudo is at hand: ${missing[*]}" >&2
      echo "Ask an administrator for: $by_hand" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  echo "Installing: ${missing[*]}"
  if ! { "${as_root[@]}" apt-get update &&
         "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
           apt-get -o DPkg::Lock::Timeout=300 install -y --no-install-recommends "${missing[@]}"
       } >"$log" 2>&1 </dev/null; then
    cat "$log" >&2
    echo "The packages could not be installed.  By hand, as root: $by_hand" >&2
    return 1
  fi
}

g31_build() {
  local preset=$1 word options=() targets=()
  shift
  for word in "$@"; do
    case $word in
      -D*) options+=("$word") ;;
      *) targets+=(--target "$word") ;;
    esac
  done
  cmake --preset "$preset" "${options[@]}" >"build/configure-$preset.log" 2>&1 ||
    { cat "build/configure-$preset.log" >&2; return 1; }
  cmake --build --preset "$preset" --parallel "$(nproc)" "${targets[@]}"
}

g31_build_with_progress() {
  local preset=$1 log=$2 line shown=0 tenth tty=
  shift 2
  [ -t 2 ] && tty=yes
  if ! g31_build "$preset" "$@" 2>&1 | while IFS= read -r line; do
         printf '%s\n' "$line" >&3
         [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] || continue
         tenth=$((10 * BASH_REMATCH[1] / BASH_REMATCH[2]))
         if [ -n "$tty" ]; then
           printf '\r  step %s of %s ' "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" >&2
         elif [ "$tenth" -gt "$shown" ]; then
           shown=$tenth
           printf '  step %s of %s\n' "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" >&2
         fi
       done 3>"$log"; then
    cat "$log" >&2
    return 1
  fi
  if [ -n "$tty" ]; then
    printf '\r%*s\r' 30 '' >&2
  fi
}
