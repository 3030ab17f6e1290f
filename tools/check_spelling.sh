#!/usr/bin/env bash
# Fails, naming the lines, when codespell finds a misspelling that tools/spelling_allowed.txt does not allow.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mapfile -t files < <(find run test ./*.md src tests docs web/src web/styles web/test python matlab examples learner scenes tools texts/en.json \
                       -type f -not -path '*/golden/*' -not -path '*/corpus/*' \
                       \( -perm -u+x -o -name '*.cc' -o -name '*.h' -o -name '*.m' -o -name '*.py' -o -name '*.ts' \
                          -o -name '*.tsx' -o -name '*.mjs' -o -name '*.css' -o -name '*.md' -o -name '*.xml' -o -name '*.xsd' \
                          -o -name '*.json' -o -name '*.jsonl' -o -name 'CMakeLists.txt' \) | sort)
codespell --ignore-words tools/spelling_allowed.txt "${files[@]}"
