#!/usr/bin/env bash
# Builds what the reports carry: libraries.js, the scripts of pages that stand behind it (flight.js, live.js, compare.js), sweep.js,
# which needs none, uplot.css and LICENSES.txt.
# Writes them into src/testbed/reporting/assets, or into the folder that is given. The same sources give the same bytes:
# package-lock.json has the version and the checksum of every library and of the bundler.
set -euo pipefail
out=$(realpath -m "${1:-"$(dirname "$0")/../src/testbed/reporting/assets"}")
cd "$(dirname "$0")"
npm ci --silent
mkdir -p "$out"
build() { # ENTRY OUT OPTIONS
  npx esbuild "src/$1.js" --bundle --minify --format=iife --target=es2020 --charset=utf8 --legal-comments=none --log-level=warning --outfile="$out/$2.js" "${@:3}"
}
build libraries libraries --global-name=libraries
in_page=(--alias:three=./src/in_page.cjs --alias:uplot=./src/in_page.cjs --alias:fflate=./src/in_page.cjs)
build main flight "${in_page[@]}"
build compare compare "${in_page[@]}"
build live live "${in_page[@]}"
build sweep sweep
cp node_modules/uplot/dist/uPlot.min.css "$out/uplot.css"
{
  echo "libraries.js contains these libraries, each under the MIT licence. The other scripts contain none."
  for name in uplot three fflate; do
    printf '\n== %s %s\n\n' "$name" "$(node -p "require('./node_modules/$name/package.json').version")"
    cat "node_modules/$name/LICENSE"
  done
} >"$out/LICENSES.txt"
