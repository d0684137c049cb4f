#!/usr/bin/env bash
# Builds the script and the style that every report carries: src/testbed/reporting/assets/flight.js and uplot.css.
set -euo pipefail
cd "$(dirname "$0")"
npm ci --silent
out=../src/testbed/reporting/assets
npx esbuild src/main.js --bundle --minify --format=iife --target=es2020 --charset=utf8 --legal-comments=none --outfile="$out/flight.js"
cp node_modules/uplot/dist/uPlot.min.css "$out/uplot.css"
{
  echo "The script of the reports (flight.js) contains these libraries, each under the MIT licence."
  for name in uplot three fflate; do
    printf '\n== %s %s\n\n' "$name" "$(node -p "require('./node_modules/$name/package.json').version")"
    cat "node_modules/$name/LICENSE"
  done
} >"$out/LICENSES.txt"
