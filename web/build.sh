#!/usr/bin/env bash
# Builds the scripts and the style that the reports carry: flight.js, sweep.js, compare.js and uplot.css in src/testbed/reporting/assets.
set -euo pipefail
cd "$(dirname "$0")"
npm ci --silent
out=../src/testbed/reporting/assets
build() { # ENTRY OUT
  npx esbuild "src/$1.js" --bundle --minify --format=iife --target=es2020 --charset=utf8 --legal-comments=none --outfile="$out/$2.js"
}
build main flight
build sweep sweep
build compare compare
cp node_modules/uplot/dist/uPlot.min.css "$out/uplot.css"
{
  echo "The scripts of the reports contain these libraries (flight.js all of them, compare.js all but three, sweep.js none), each under the MIT licence."
  for name in uplot three fflate; do
    printf '\n== %s %s\n\n' "$name" "$(node -p "require('./node_modules/$name/package.json').version")"
    cat "node_modules/$name/LICENSE"
  done
} >"$out/LICENSES.txt"
