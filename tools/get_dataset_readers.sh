#!/usr/bin/env bash
# tools/get_dataset_readers.sh
# Installs the packages that write datasets, and others that read them, into build/dataset_readers,
# for the tests of smile.datasets: they are skipped without. For Debian's Python and its numpy.
# 410 MB.
set -euo pipefail
cd "$(dirname "$0")/.."

target=build/dataset_readers
packages=(pyarrow==19.0.1 h5py==3.13.0                                              # write
          zarr==2.18.7 numcodecs==0.15.1 asciitree==0.3.3 fasteners==0.19 deprecated==1.2.18 wrapt==1.17.2
          mcap==1.6.0 mcap-protobuf-support==0.6.0 foxglove-schemas-protobuf==0.4.0 protobuf==7.36.2
          duckdb==1.4.1 av==15.1.0                                                  # read
          pandas==2.2.3 python-dateutil==2.9.0.post0 pytz==2025.2 tzdata==2025.2 six==1.17.0)
if [[ $(cat "$target/packages.txt" 2>/dev/null) != "${packages[*]}" ]]; then
  rm -rf "$target"
  /usr/bin/python3 -m pip install --quiet --no-deps --target "$target" "${packages[@]}"
  echo "${packages[*]}" >"$target/packages.txt"
fi
echo "$target"
