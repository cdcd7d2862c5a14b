#!/usr/bin/env bash
# deb_test.sh BUILD_FOLDER WORK_FOLDER: makes the Debian package, looks at its fields and files, and
# runs the command and the C example from where it is unpacked.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
build="$1" work="$2"
rm -rf "$work"
mkdir -p "$work"
(cd "$work" && cpack -G DEB --config "$build/CPackConfig.cmake" -B "$work/pack") >"$work/cpack.log" 2>&1 ||
  { cat "$work/cpack.log"; exit 1; }
packages=("$work"/pack/*.deb)
deb="${packages[0]}"
ls -l "$deb"

echo "== fields"
dpkg-deb --field "$deb"
field() { dpkg-deb --field "$deb" "$1"; }
[ "$(field Package)" = seaway ]
[ "$(field Architecture)" = "$(dpkg --print-architecture)" ]
[ -n "$(field Maintainer)" ] && [ -n "$(field Description)" ]
for needed in libc6 libstdc++6 libopenvdb libyaml-cpp libtbb libfftw3; do
  field Depends | grep -q "$needed" || { echo "Depends lacks $needed"; exit 1; }
done

echo "== files"
dpkg-deb --contents "$deb" | awk '{print $6}' >"$work/files.txt"
for file in ./usr/bin/seaway ./usr/lib/libseaway.so ./usr/lib/libseaway.so.0 ./usr/include/seaway.h \
  ./usr/lib/cmake/Seaway/SeawayConfig.cmake ./usr/lib/pkgconfig/seaway.pc \
  ./usr/share/seaway/scenes/canaveral.yaml ./usr/share/seaway/SCHEMA.md \
  ./usr/share/doc/seaway/copyright ./usr/share/doc/seaway/examples/query_height.c; do
  grep -qx "$file" "$work/files.txt" || { echo "$file is missing"; cat "$work/files.txt"; exit 1; }
done
! grep -vE '^\./(usr/(bin|lib|include|share)/.*|usr/|)$' "$work/files.txt"

echo "== unpacked"
dpkg-deb -x "$deb" "$work/root"
usr="$work/root/usr"
"$usr/bin/seaway" --version
export PKG_CONFIG_PATH="$usr/lib/pkgconfig" LD_LIBRARY_PATH="$usr/lib"
# shellcheck disable=SC2046
cc -std=c11 "$usr/share/doc/seaway/examples/query_height.c" $(pkg-config --cflags --libs seaway) -o "$work/example"
"$work/example" "$usr/share/seaway/scenes/canaveral.yaml"
python3 "$usr/share/doc/seaway/examples/query_height.py" "$usr/share/seaway/scenes/canaveral.yaml"
! ldd "$usr/lib/libseaway.so.0" | grep "not found"
rm -rf "$work"
