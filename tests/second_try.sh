#!/usr/bin/env bash
# second_try.sh COMMAND...: a test of programs that wait for each other by the clock: a page and its browser, a robot and its
# master. A busy machine may miss what a person would not: a test that fails is tried once more, and says so.
# Only for these: what the clock does not reach gets no second try.
set -uo pipefail
"$@"
code=$?
((code == 0 || code == 77)) && exit $code  # 77: skipped
echo "once more: $*"
exec "$@"
