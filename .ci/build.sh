# Shared by ./run and ./test: installs missing packages, configures and builds.
# Sourced, with the repository as the current folder. Options through the environment:
#   SEAWAY_PRESET  CMake preset to build (default: release)
#   SEAWAY_JOBS    parallel compilations (default: number of processors)
set -euo pipefail

preset="${SEAWAY_PRESET:-release}"
jobs="${SEAWAY_JOBS:-$(nproc)}"
build_dir="build/$preset"

say() { printf '== %s\n' "$*" >&2; }

seaway_install_packages() {
  local wanted missing=() package
  wanted=$(sed -e 's/#.*//' .ci/packages.txt | awk 'NF {print $1}')
  for package in $wanted; do
    dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  say "installing Debian packages: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { say "not root and no sudo: as root, run: apt-get install ${missing[*]}"; exit 1; }
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}

seaway_build() {
  seaway_install_packages
  if [ ! -f "$build_dir/build.ninja" ]; then
    say "configuring $build_dir"
    cmake --preset "$preset" >&2
  fi
  say "building $build_dir ($jobs jobs)"
  local log="$build_dir/build.log"
  if ! cmake --build --preset "$preset" -j "$jobs" >"$log" 2>&1; then
    cat "$log" >&2
    say "the build failed; the log is $log"
    exit 1
  fi
  tail -n 1 "$log" >&2
}
