#!/usr/bin/env bash
# Copies frame_gpu_bench and the libraries it needs into a folder, to be carried to a machine with a
# graphics card that has none of them:
#   tests/bench/pack_frame_gpu_bench.sh build/gpu_bench
# and there
#   LD_LIBRARY_PATH=build/gpu_bench build/gpu_bench/frame_gpu_bench --backend egl:0
# Where EGL's dispatch library is missing there as well, add build/gpu_bench/glvnd to the path; where
# it then finds no driver, name the driver's file in __EGL_VENDOR_LIBRARY_FILENAMES.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
out="${1:?folder to fill}"
bench="build/${SEAWAY_PRESET:-release}/tests/bench/frame_gpu_bench"
mkdir -p "$out/glvnd"
cp "$bench" "$out/"
strip "$out/frame_gpu_bench"
ldd "$bench" | awk '$3 ~ /^\// {print $3}' | while read -r library; do
  case "$(basename "$library")" in
    libc.so* | libm.so* | ld-linux*) ;;  # belong to the machine
    libEGL.so* | libGLdispatch.so*) cp -L "$library" "$out/glvnd/" ;;
    *) cp -L "$library" "$out/" ;;
  esac
done
du -sh "$out"
