# Installs what is missing on Debian 12; to be sourced.  Nothing is called when nothing is missing.
#
#   g31_install_packages LOGFILE

G31_PACKAGES=(
  g++ cmake ninja-build python3
  libeigen3-dev libfmt-dev libcli11-dev nlohmann-json3-dev libtomlplusplus-dev
  libassimp-dev libfcl-dev libccd-dev
  libgtest-dev libgmock-dev libbenchmark-dev
)

g31_missing_packages() {
  local package
  for package in "${G31_PACKAGES[@]}"; do
    if ! dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed'; then
      printf '%s ' "$package"
    fi
  done
}

g31_install_packages() {
  local log=$1 missing as_root=()
  missing=$(g31_missing_packages)
  if [ -z "$missing" ]; then
    return 0
  fi
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "These packages are missing, and neither root nor sudo is at hand: $missing" >&2
      echo "Ask an administrator for: apt-get install $missing" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  echo "Installing: $missing"
  # shellcheck disable=SC2086  # the list is words on purpose
  if ! { "${as_root[@]}" apt-get update &&
         "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
           apt-get install -y --no-install-recommends $missing; } >"$log" 2>&1; then
    cat "$log" >&2
    return 1
  fi
}
