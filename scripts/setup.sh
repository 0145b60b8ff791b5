# Sourced by the other scripts: installs what is missing, configures and builds.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '\033[1m%s\033[0m\n' "$*" >&2; }
fail() { printf '%s\n' "$*" >&2; exit 2; }

# packages GROUP...: the names of these groups in scripts/packages.txt.
packages() {
  local group
  for group in "$@"; do
    awk -v group="$group" '$1 == group {print $2}' "$root/scripts/packages.txt"
  done
}

missing_packages() {
  local wanted installed
  wanted=$(packages "$@" | sort -u)
  # shellcheck disable=SC2086
  installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' $wanted 2>/dev/null |
    awk '$1 == "installed" {print $2}' | sort -u)
  comm -23 <(echo "$wanted") <(echo "$installed")
}

# install GROUP...: apt-get what is missing, with sudo where not root.
install() {
  command -v dpkg-query >/dev/null || fail "honka's scripts install Debian packages; on another \
system install the counterparts of scripts/packages.txt, then: cmake --preset default && ninja -C build honka"
  local missing as_root=()
  missing=$(missing_packages "$@")
  [ -z "$missing" ] && return
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "these packages are missing: $(echo $missing). \
Ask an administrator to run: apt-get install $(echo $missing)"
    as_root=(sudo)
  fi
  say "Installing $(echo "$missing" | wc -l) packages: $(echo $missing)"
  "${as_root[@]}" apt-get update -q >/dev/null || say "apt-get update failed; trying with the lists at hand"
  # shellcheck disable=SC2086
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends \
    $missing >/dev/null ||
    fail "apt-get could not install: $(echo $(missing_packages "$@")). \
See the lines above; try: apt-get update && apt-get install $(echo $missing)"
}

# build FOLDER "CMAKE OPTIONS" TARGET...
build() {
  local folder=$1 options=$2
  shift 2
  [ -n "${CI:-}" ] && options="$options -DHONKA_WERROR=ON"
  # shellcheck disable=SC2086
  if [ ! -f "$folder/build.ninja" ] || [ -n "$options" ]; then
    cmake -G Ninja -S "$root" -B "$folder" $options >"$folder.log" 2>&1 ||
      { cat "$folder.log" >&2; fail "cmake could not configure; its log is above"; }
    rm -f "$folder.log"
  fi
  say "Building $* in ${folder#"$root"/}"
  cmake --build "$folder" --target "$@" >&2 || fail "the build failed; its first error is above"
}

# Threads that wait must not spin: cores are often shared.
export OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive}
