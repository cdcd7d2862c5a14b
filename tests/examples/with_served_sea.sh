#!/usr/bin/env bash
# Runs a host's program with the name of a sea that is served meanwhile:
#   with_served_sea.sh build/release/seaway configs/scenes/canaveral.yaml PROGRAM
set -euo pipefail
name="seaway-example-$$"
"$1" serve "$2" --shm "$name" &
server=$!
trap 'kill -TERM $server 2>/dev/null || true' EXIT
"$3" "$name"
kill -TERM $server
wait $server
