#!/usr/bin/env bash
# exported_symbols.sh LIBRARY HEADER: the library exports the functions of the header, no more, no less.
set -euo pipefail
exported=$(nm -D --defined-only "$1" | awk '$2 != "A" {sub(/@.*/, "", $3); print $3}' | sort)
declared=$(grep -oE 'seaway_[a-z0-9_]+\(' <(grep -v 'static inline' "$2" | grep -A1 SEAWAY_API) |
  tr -d '(' | sort -u)
diff <(echo "$declared") <(echo "$exported") ||
  { echo "< declared in $2, > exported by $1"; exit 1; }
echo "$(wc -l <<<"$exported") functions"
