#!/usr/bin/env bash
# tools/fuzz.sh [SECONDS]: feeds the readers of outside files with broken ones, SECONDS (600) for each.
# tools/fuzz.sh python [SECONDS] [SEED]: calls the simulator in Python at random for that long, with seeds from
#     SEED (1) on, under the address sanitizer.
#
# First the inputs kept in tests/fuzz are run again, then libFuzzer makes new ones of them. An input
# that crashes, hangs, leaks, takes 500 MB or breaks a claim is kept in tests/fuzz/found, from where
# every later run and ./test take it up. Exits 1 when there is one.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

# Calls python/test/fuzz_test.py with one seed after the other. The simulator has sanitizers, Python itself has not:
# their library is loaded before it, and Python takes each piece of memory from it.
fuzz_python() {
  local seconds=$1 seed=$2 log
  install_packages test
  cd "$project"
  build asan smile_simulator_native smile_motion_native smile_brain_native
  log=$(mktemp)
  trap "rm -f '$log'" EXIT
  SECONDS=0
  while ((SECONDS < seconds)); do
    if ! env PYTHONPATH=python:build/asan/python PYTHONMALLOC=malloc PYTHONDONTWRITEBYTECODE=1 \
        LD_PRELOAD="$(clang -print-file-name=libclang_rt.asan-x86_64.so) $(g++ -print-file-name=libstdc++.so.6)" ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1 \
        /usr/bin/python3 python/test/fuzz_test.py "$project" --seed "$seed" --calls 2000 --say >"$log" 2>&1; then
      tail -60 "$log" >&2
      say "finding: fuzz_test.py --seed $seed --calls 2000"
      return 1
    fi
    seed=$((seed + 1))
  done
  echo "python: seeds $2 to $((seed - 1)), no findings; the last: $(tail -1 "$log")"
}

if [[ ${1:-} == python ]]; then
  [[ ${2:-600} =~ ^[1-9][0-9]*$ && ${3:-1} =~ ^[0-9]+$ ]] || { say "usage: tools/fuzz.sh python [SECONDS] [SEED]"; exit 2; }
  fuzz_python "${2:-600}" "${3:-1}"
  exit
fi
seconds=${1:-600}
[[ $seconds =~ ^[1-9][0-9]*$ ]] || { say "usage: tools/fuzz.sh [SECONDS]"; exit 2; }
install_packages test
cd "$project"
build asan smile_fuzzers
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
# A small quarantine, so that the limit is about our memory, not about that of the sanitizer.
export ASAN_OPTIONS=quarantine_size_mb=16
# Sanitizers are slow, and machines busy: what takes this long hangs.
limits=(-timeout=20 -rss_limit_mb=500)
findings=0

# seeds_of SUBJECT DIRECTORY: puts what the project itself ships there, the way the target takes it.
seeds_of() {
  local file format
  case $1 in
    json) find examples robots -name '*.json*' ;;
    xml) find scenes robots -name '*.xml' -o -name '*.urdf' -o -name '*.dae' ;;
    scene) find scenes -name '*.xml' ;;
    robot) find robots -name '*.urdf' ;;
    mesh) find scenes \( -name '*.stl' -o -name '*.obj' -o -name '*.dae' -o -name '*.gltf' -o -name '*.glb' \) -size -128k ;;
  esac | while read -r file; do
    format=
    case $1/${file##*.} in
      mesh/stl) format=0 ;; mesh/obj) format=1 ;; mesh/dae) format=2 ;; mesh/gltf) format=3 ;; mesh/glb) format=4 ;;
    esac
    { printf %s "$format"; cat "$file"; } >"$2/$(tr / _ <<<"$file")"
  done
}

# fail LOG: shows what the fuzzer said of a finding, but not all of its progress.
fail() {
  findings=$((findings + 1))
  grep -vE '^(#[0-9]|INFO:|NEW_FUNC)|^Running:|^Executed' "$1" | head -60 >&2
}

# replay SUBJECT CORPUS FILE...: copies those that are taken well to CORPUS, to begin with.
replay() {
  local program=build/asan/bin/smile_$1_fuzzer corpus=$2 log="$scratch/$1.log" file
  shift 2
  # Nearly always all is well; else one process for each, so that one finding does not hide the next.
  if "$program" "${limits[@]}" -artifact_prefix="$scratch/" "$@" >"$log" 2>&1; then
    cp --backup=numbered "$@" "$corpus"
    return
  fi
  for file in "$@"; do
    if "$program" "${limits[@]}" -artifact_prefix="$scratch/" "$file" >"$log" 2>&1; then
      cp --backup=numbered "$file" "$corpus"
    else
      say "finding: $file"
      fail "$log"
    fi
  done
}

# fuzz SUBJECT: replays, then looks for new findings; one line on stdout. Fails when there is one.
fuzz() {
  local subject=$1 corpus="$scratch/corpus/$1" seeds="$scratch/seeds/$1" log="$scratch/$1.log" new="$scratch/new/$1"
  local found="tests/fuzz/found/$1" options=() files=() runs covered
  mkdir -p "$corpus" "$seeds" "$new"
  seeds_of "$subject" "$seeds"
  local folders=("$seeds" "tests/fuzz/corpus/$subject")
  if [[ -d $found ]]; then folders+=("$found"); fi
  mapfile -t files < <(find "${folders[@]}" -type f | sort)
  replay "$subject" "$corpus" "${files[@]}"
  if [[ -f tests/fuzz/$subject.dict ]]; then options+=(-dict="tests/fuzz/$subject.dict"); fi
  if ! "build/asan/bin/smile_${subject}_fuzzer" "${limits[@]}" "${options[@]}" -max_len=65536 \
      -max_total_time="$seconds" -print_final_stats=1 -artifact_prefix="$new/" \
      "$corpus" >"$log" 2>&1; then
    fail "$log"
    # A process that the importer of DAE files gives up leaves inputs too; it is no finding.
    mkdir -p "$found"
    cp "$new"/* "$found/" || rmdir --ignore-fail-on-non-empty "$found"
    say "finding: kept in $found"
  fi
  # Children of the importer that die print their own numbers first.
  runs=$(sed -n 's/^stat::number_of_executed_units: //p' "$log" | tail -1)
  covered=$(sed -nE 's/^#.* cov: ([0-9]+).*/\1/p' "$log" | tail -1)
  echo "$subject: ${#files[@]} kept inputs, ${runs:-0} made and tried, ${covered:-0} edges covered," \
       "$findings findings"
  ((findings == 0))
}

# As many at a time as there are processors.
failed=0
pids=()
for target in build/asan/bin/smile_*_fuzzer; do
  subject=${target##*/smile_}
  fuzz "${subject%_fuzzer}" &
  pids+=($!)
  if ((${#pids[@]} >= $(nproc))); then
    wait "${pids[0]}" || failed=1
    pids=("${pids[@]:1}")
  fi
done
for pid in "${pids[@]}"; do wait "$pid" || failed=1; done
((failed == 0))
