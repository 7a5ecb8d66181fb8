# shellcheck shell=bash
# Common functions of ./verify, ./check, ./solve, docs/site/build and bindings/explorer/build. Source this file, do not run it. All its
# messages go to stderr, so that stdout holds only the result.

root=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
# The command as a person types it in the root folder: verify, docs/site/build.
command_name=$(readlink -f -- "$(dirname -- "$0")")/$(basename -- "$0")
[[ $command_name == "$root"/* ]] && command_name=${command_name#"$root"/} || command_name=$(basename -- "$0")

say() { printf '%s: %s\n' "$command_name" "$*" >&2; }

# fail STATUS MESSAGE: status 2 for an error that the user can correct, 3 for a failure during the work. 1 is reserved
# for mathematics.
fail() {
  local status=$1
  shift
  say "$*"
  exit "$status"
}

# packages_for KIND...: prints the names that cmake/packages.txt lists under these kinds.
packages_for() {
  local kind package
  while read -r kind package _; do
    [[ " $* " == *" $kind "* ]] && printf '%s\n' "$package"
  done <"$root/cmake/packages.txt"
  return 0
}

# missing_packages PACKAGE...: prints those that are not installed.
missing_packages() {
  local installed
  # dpkg-query fails if it does not know one of the packages; that package is missing from its output, too.
  installed=$(dpkg-query --show --showformat='${Package} ${db:Status-Status}\n' "$@" 2>/dev/null) || true
  local package
  for package; do
    grep -qx -- "$package installed" <<<"$installed" || printf '%s\n' "$package"
  done
}

# apt_get ARGUMENT...
apt_get() {
  local as_root=()
  if [[ $(id -u) != 0 ]]; then
    as_root=(sudo)
    # Without a terminal no password can be typed: fail at once and do not wait.
    [[ -t 0 ]] || as_root+=(--non-interactive)
  fi
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get --quiet -o DPkg::Lock::Timeout=120 "$@" >&2
}

# install_packages PACKAGE...: returns false if apt-get failed.
install_packages() {
  say "installing with apt-get: $*"
  apt_get update || say "the package lists could not be refreshed; going on with those present"
  apt_get install --yes --no-remove --no-install-recommends -- "$@"
}

# require_packages INSTALL KIND...: installs missing packages if INSTALL = yes; otherwise names them and fails.
require_packages() {
  local install=$1
  shift
  local packages missing by_hand='apt-get install --no-install-recommends'
  mapfile -t packages < <(packages_for "$@")
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    fail 2 "this is no Debian system (no apt-get); install by hand what Debian calls ${packages[*]}," \
      "then run: cmake --preset release && cmake --build --preset release"
  fi
  mapfile -t missing < <(missing_packages "${packages[@]}")
  ((${#missing[@]})) || return 0

  if [[ $(id -u) != 0 ]]; then
    [[ $install != yes ]] || command -v sudo >/dev/null ||
      fail 2 "not root, and there is no sudo; as root: $by_hand ${missing[*]}"
    by_hand="sudo $by_hand"
  fi
  [[ $install == yes ]] || fail 2 "not installed: ${missing[*]}; install with: $by_hand ${missing[*]}"
  install_packages "${missing[@]}" || fail 3 "apt-get could not install: ${missing[*]}"
}

# offer_packages INSTALL KIND...: the same for optional packages.
offer_packages() {
  local install=$1
  shift
  local packages missing
  mapfile -t packages < <(packages_for "$@")
  mapfile -t missing < <(missing_packages "${packages[@]}")
  ((${#missing[@]})) || return 0
  if [[ $install != yes ]] || ! install_packages "${missing[@]}"; then
    say "going on without ${missing[*]}; the tests that need them say so"
  fi
}

# configure PRESET [OPTION...]: shows the output of CMake only if it fails.
configure() {
  local output
  # CMake looks for presets in the current directory.
  output=$(cd -- "$root" && cmake --preset "$@" 2>&1) && return
  printf '%s\n' "$output" >&2
  fail 3 "configuring failed"
}

# build DIRECTORY [OPTION...]
build() {
  local directory=$1
  shift
  cmake --build "$directory" "$@" >&2 || fail 3 "building failed"
}
