#!/usr/bin/env bash
# Installs the Debian packages that porefines builds with, where one is missing. Quiet when all is there.
set -euo pipefail
packages=(
  build-essential cmake ninja-build ccache pkg-config git python3
  libopenmpi-dev openmpi-bin libhdf5-openmpi-dev
  libopencv-core-dev libopencv-imgproc-dev libopencv-imgcodecs-dev libopencv-videoio-dev
  libtiff-dev libpng-dev zlib1g-dev
  libavformat-dev libavcodec-dev libswscale-dev
  libcli11-dev libfmt-dev libtomlplusplus-dev
  python3-numpy python3-h5py
  libgtest-dev libbenchmark-dev clang clang-format clang-tidy libclang-rt-14-dev
)
# The page of reports: npm fetches and esbuild bundles its libraries; chromium is for its tests.
command -v npm >/dev/null || packages+=(nodejs npm)
command -v chromium >/dev/null || packages+=(chromium)
missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q '^install ok installed' || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0
echo "installing ${#missing[@]} Debian packages: ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "please install these as root: apt-get install ${missing[*]}"; exit 2; }
  as_root=(sudo)
fi
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
