#!/usr/bin/env bash
# Builds the scripts and the style of the reports from their sources again, and compares each with what is shipped, byte by byte.
# Status 1 if any differs: then run build.sh and commit what it wrote.
set -euo pipefail
shipped=$(realpath "$(dirname "$0")/../src/testbed/reporting/assets")
built=$(mktemp -d)
trap 'rm -rf "$built"' EXIT
"$(dirname "$0")/build.sh" "$built"
status=0
for file in "$built"/*; do
  cmp "$file" "$shipped/$(basename "$file")" || status=1
done
((status)) || echo "the scripts of the reports are those that their sources give"
exit $status
