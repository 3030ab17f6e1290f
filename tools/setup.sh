# Shared by ./run and ./test: installs missing packages and builds. Sourced, not run.
# Says what it does and how far it is; shows the output of a step only when the step fails.

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# say WORDS: one line on stderr, so that stdout stays the program's own.
say() { echo "smile: $*" >&2; }

# in_words SECONDS: a duration for people.
in_words() {
  if (($1 < 90)); then echo "$1 s"; else echo "$((($1 + 30) / 60)) min"; fi
}

# show_progress WHAT: reads a step's output. Where a line begins with a count, as those of ninja and
# ctest do, shows how far the step is and how long the rest will take at this pace: in a terminal on
# one line, elsewhere on a line of its own every minute.
show_progress() {
  local what=$1 line text started=$SECONDS shown=$SECONDS
  while IFS= read -r line; do
    [[ $line =~ ^[[:space:]]*\[?([0-9]+)/([0-9]+)[^0-9] ]] || continue
    local done=${BASH_REMATCH[1]} total=${BASH_REMATCH[2]} passed=$((SECONDS - started))
    text="smile: $what: $done of $total"
    if ((passed >= 5 && done > 0)); then
      text+=", about $(in_words $((passed * (total - done) / done))) left"
    fi
    if [[ -t 2 ]]; then
      printf '\r%s\033[K' "$text" >&2
    elif ((SECONDS - shown >= 60)); then
      echo "$text" >&2
      shown=$SECONDS
    fi
  done
  if [[ -t 2 ]]; then printf '\r\033[K' >&2; fi
}

# quietly WHAT COMMAND...: runs it and shows its progress; on failure shows all it printed and ends.
quietly() {
  local what=$1 log started=$SECONDS
  shift
  log=$(mktemp)
  if ! "$@" 2>&1 | tee "$log" | show_progress "$what"; then
    cat "$log" >&2
    rm -f "$log"
    say "$what failed: $*"
    exit 3
  fi
  rm -f "$log"
  if ((SECONDS - started > 1)); then say "$what took $(in_words $((SECONDS - started)))"; fi
}

# run_tests PRESET [OPTION...]: runs the tests that ctest finds. In a terminal it shows how far it
# is, and of the output only what failed; elsewhere a line for each test.
run_tests() {
  local log
  # One more than there are cores: some tests mostly wait.
  export CTEST_PARALLEL_LEVEL=$(($(nproc) + 1))
  if [[ ! -t 1 ]]; then
    ctest --preset "$@"
    return
  fi
  log=$(mktemp)
  if ! ctest --preset "$@" 2>&1 | tee "$log" | show_progress "testing ($1)"; then
    grep -vE '^ *(Start +[0-9]+:|[0-9]+/[0-9]+ Test +#.* Passed )' "$log" || true
    rm -f "$log"
    exit 8
  fi
  tail -n 4 "$log"
  rm -f "$log"
}

# list_packages [PART]: names from packages.txt, of the beginning and of the [PART] asked for.
list_packages() {
  awk -v wanted="${1:-}" '
    /^\[/ { part = substr($1, 2, length($1) - 2); next }
    /^[^#[:space:]]/ { if (part == "" || part == wanted) print $1 }' "$project/packages.txt"
}

# install_packages [PART]: installs what is missing, as root or through sudo.
install_packages() {
  local missing=() package installed
  installed=" $(dpkg-query -W -f '${Package}/${Status} ' 2>/dev/null) "
  for package in $(list_packages "${1:-}"); do
    [[ $installed == *" $package/install ok installed "* ]] || missing+=("$package")
  done
  ((${#missing[@]})) || return 0
  local as_root=()
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      say "these Debian packages are missing, and there is no sudo to install them:"
      say "  ${missing[*]}"
      exit 3
    fi
    as_root=(sudo)
  fi
  say "installing ${#missing[@]} Debian packages: ${missing[*]}"
  quietly "apt-get update" "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update
  quietly "apt-get install" "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y --no-install-recommends "${missing[@]}"
}

# build PRESET [TARGET...]: configures again when the presets have changed, then builds what changed.
build() {
  local preset=$1 dir="$project/build/$1" targets=()
  shift
  (($# == 0)) || targets=(--target "$@")
  mkdir -p "$dir"
  exec 9>"$dir/.lock"
  flock 9
  if [[ ! -f $dir/build.ninja || $project/CMakePresets.json -nt $dir/build.ninja ]]; then
    say "configuring ($preset)"
    (cd "$project" && quietly "configuring" cmake --fresh --preset "$preset")
  fi
  if [[ ! -f $dir/.built ]]; then say "building ($preset); the first time takes a few minutes"; fi
  (cd "$project" && quietly "building ($preset)" cmake --build --preset "$preset" "${targets[@]}")
  touch "$dir/.built"
  exec 9>&-
}

# install_page_packages: what builds the studio's page, and what its tests need, into web/node_modules.
install_page_packages() {
  local web="$project/web"
  if ! command -v node >/dev/null || ! command -v npm >/dev/null; then install_packages studio; fi
  if [[ ! $web/node_modules/.package-lock.json -nt $web/package-lock.json ]]; then
    (cd "$web" && quietly "npm ci" npm ci)
    touch "$web/node_modules/.package-lock.json"
  fi
}

# build_page: the studio's page, into build/page, where `smile studio` looks for it.
build_page() {
  local web="$project/web" page="$project/build/page" newer
  mkdir -p "$project/build"
  exec 9>"$project/build/.page.lock"
  flock 9
  if [[ -f $page/.built ]]; then
    newer=$(find "$web" "$web/../texts" -name node_modules -prune -o -name dist -prune -o -name test -prune -o -newer "$page/.built" -print -quit)
  fi
  if [[ ! -f $page/.built || -n $newer ]]; then
    install_page_packages
    (cd "$web" && quietly "building the page" node build.mjs "$page")
    touch "$page/.built"
  fi
  exec 9>&-
}
