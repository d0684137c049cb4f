#!/usr/bin/env bash
# Builds the scripts and the style that the reports carry: flight.js, live.js, sweep.js, compare.js, uplot.css and LICENSES.txt.
# Writes them into src/testbed/reporting/assets, or into the folder that is given. The same sources give the same bytes:
# package-lock.json has the version and the checksum of every library and of the bundler.
set -euo pipefail
out=$(realpath -m "${1:-"$(dirname "$0")/../src/testbed/reporting/assets"}")
cd "$(dirname "$0")"
npm ci --silent
mkdir -p "$out"
build() { # ENTRY OUT
  npx esbuild "src/$1.js" --bundle --minify --format=iife --target=es2020 --charset=utf8 --legal-comments=none --log-level=warning --outfile="$out/$2.js"
}
build main flight
build sweep sweep
build compare compare
build live live
cp node_modules/uplot/dist/uPlot.min.css "$out/uplot.css"
{
  echo "The scripts of the reports contain these libraries (flight.js and compare.js all of them, live.js all but fflate, sweep.js none), each under the MIT licence."
  for name in uplot three fflate; do
    printf '\n== %s %s\n\n' "$name" "$(node -p "require('./node_modules/$name/package.json').version")"
    cat "node_modules/$name/LICENSE"
  done
} >"$out/LICENSES.txt"
