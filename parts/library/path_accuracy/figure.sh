#!/bin/sh
# figure.sh NUMBER [mpf]: runs, evaluates and draws one figure of the paper, as figure_NUMBER.svg.
set -eu
here=$(dirname "$0")
g31=${G31:-g31}
number=${1:-}
ending=${2:-nc}
circle="circle --radius 50 --centre 0,0"
square="square --side 100 --centre 0,0"
feed=3000
control=0
case $number in
  9) feed=2000 evaluation="$circle --magnify 1" ;;
  10) feed=2000 evaluation="$circle --magnify 1000" ;;
  11) feed=2000 evaluation="$circle --magnify 1000 --detail 0,45,30" ;;
  12) evaluation="$square --magnify 50" ;;
  13) evaluation="$square --magnify 1 --detail 49,49,4" ;;
  14) control=1 evaluation="$square --magnify 1 --detail 49,49,4" ;;
  15) feed=1000 program=square evaluation=speed ;;
  16) program=square evaluation=speed ;;
  17) control=1 program=square evaluation=speed ;;
  19) feed=1000 evaluation="diagonal --target 50,50 --on 300" ;;
  *) echo "figure.sh NUMBER [mpf]: 9 to 17 or 19" >&2; exit 2 ;;
esac
program=${program:-${evaluation%% *}}
sheets="-s $here/machine.toml"
[ "$program" != diagonal ] || sheets="$sheets -s $here/short_axes.toml"
names="#500 #501"
[ "$ending" != mpf ] || names="R1 R2"
record=$(mktemp)
trap 'rm -f "$record"' EXIT
# The words of these variables are to be parted.
# shellcheck disable=SC2086
"$g31" run "$here/$program.$ending" $sheets --set "${names% *}=$feed" --set "${names#* }=$control" \
  --trace "$record" --trace-period 182.32us
# shellcheck disable=SC2086
"$g31" evaluate ${evaluation%% *} "$record" ${evaluation#"${evaluation%% *}"} --svg "figure_$number.svg"
