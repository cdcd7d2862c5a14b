#!/usr/bin/env bash
# The binary interface of libseaway.so against the dump kept beside this script.
#   binary_interface.sh check LIBRARY FOLDER   fails where the two differ; writes into FOLDER
#   binary_interface.sh renew LIBRARY          keeps the library's as it is now
# Only functions that are exported and the types they take count, without places in sources, so that
# compilers and what is behind the interface make no difference.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
kept="$here/seaway.abi"

dump() {
  abidw --exported-interfaces-only --no-show-locs --no-corpus-path --no-comp-dir-path \
    --no-architecture --no-elf-needed --type-id-style hash --out-file "$1" "$library"
}

library="$2"
case "$1" in
  renew)
    dump "$kept"
    echo "kept $kept: bump SOVERSION in sim_bridge/capi/CMakeLists.txt if it breaks programs"
    ;;
  check)
    dump "$3/seaway.abi"
    if ! abidiff --no-show-locs "$kept" "$3/seaway.abi"; then
      echo "The binary interface is not the one kept. If that is meant:"
      echo "  $here/binary_interface.sh renew $library"
      exit 1
    fi
    ;;
esac
