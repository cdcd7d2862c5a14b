#!/usr/bin/env bash
# install_test.sh BUILD_FOLDER WORK_FOLDER: installs into a folder that then moves, and builds and runs
# projects that find it there by find_package and by pkg-config.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
build="$1" work="$2"
rm -rf "$work"
mkdir -p "$work"
cmake --install "$build" --prefix "$work/first" >/dev/null
cmake --install "$build" --prefix "$work/first" --component cpp >/dev/null
mv "$work/first" "$work/prefix"
prefix="$work/prefix"

echo "== find_package"
cmake -S "$here" -B "$work/build" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_C_FLAGS="-Wall -Werror" \
  -DCMAKE_CXX_FLAGS="-Wall -Werror" >"$work/configure.log" || { cat "$work/configure.log"; exit 1; }
cmake --build "$work/build" >"$work/build.log" || { cat "$work/build.log"; exit 1; }
configs="$(cat "$work/build/configs.txt")"
found="$("$work/build/consumer" "$configs/scenes/canaveral.yaml")"
echo "$found"
"$work/build/consumer_cpp"

echo "== the C++ library"
cmake -S "$here/cpp" -B "$work/cpp" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_FLAGS="-Wall -Werror" \
  >"$work/configure.log" || { cat "$work/configure.log"; exit 1; }
cmake --build "$work/cpp" >"$work/build.log" || { cat "$work/build.log"; exit 1; }
"$work/cpp/height"

echo "== pkg-config"
export PKG_CONFIG_PATH="$prefix/lib/pkgconfig"
# shellcheck disable=SC2046
cc -std=c11 -Wall -Werror -pedantic "$here/consumer.c" $(pkg-config --cflags --libs seaway) -o "$work/consumer"
again="$(LD_LIBRARY_PATH="$prefix/lib" "$work/consumer" "$(pkg-config --variable=configs seaway)/scenes/canaveral.yaml")"
echo "$again"
[ "$found" = "$again" ]

echo "== the command"
[ "$("$prefix/bin/seaway" --version)" = "$(pkg-config --modversion seaway)" ]
"$prefix/bin/seaway" query "$configs/scenes/canaveral.yaml" --time 1 --at 28.878,-78.467
rm -rf "$work"
