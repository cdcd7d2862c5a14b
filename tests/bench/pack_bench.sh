#!/usr/bin/env bash
# Copies benchmarks and the libraries they need into a folder, to be carried to a machine that has
# none of them:
#   tests/bench/pack_bench.sh build/carried frame_gpu_bench compare_views
# and there
#   LD_LIBRARY_PATH=build/carried build/carried/frame_gpu_bench --backend egl:0
# Where EGL's dispatch library is missing there as well, add build/carried/glvnd to the path; where it
# then finds no driver, name the driver's file in __EGL_VENDOR_LIBRARY_FILENAMES.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
out="${1:?folder to fill}"
shift
mkdir -p "$out/glvnd"
for name in "${@:?names of benchmarks}"; do
  bench="build/${SEAWAY_PRESET:-release}/tests/bench/$name"
  cp "$bench" "$out/"
  strip "$out/$name"
  ldd "$bench" | awk '$3 ~ /^\// {print $3}' | while read -r library; do
    case "$(basename "$library")" in
      libc.so* | libm.so* | libpthread.so* | libdl.so* | librt.so* | ld-linux*) ;;  # belong to the machine
      libEGL.so* | libGLdispatch.so*) cp -L "$library" "$out/glvnd/" ;;
      *) cp -L "$library" "$out/" ;;
    esac
  done
done
du -sh "$out"
