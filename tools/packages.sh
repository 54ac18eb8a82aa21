# Debian packages that Riffle needs, and how to install those that are missing. To be sourced by bash.

build_packages=(
    g++ cmake ninja-build pkg-config ca-certificates
    libboost-dev libcli11-dev libeigen3-dev libfmt-dev libhdf5-dev libkissfft-dev libspdlog-dev
    libtbb-dev libtomlplusplus-dev nlohmann-json3-dev
)
test_packages=(
    libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev libtiff-dev clang-format-14
    python3 python3-h5py python3-matplotlib python3-numpy python3-xarray python3-paraview chromium-headless-shell mount valgrind
)
lint_packages=(clang-tidy-14)

# Node.js and npm bring the report's figure library; a machine that has them from elsewhere keeps its own.
node_packages() {
    command -v npm >/dev/null && command -v node >/dev/null || echo nodejs npm
}

say() { printf '\n== %s\n' "$*"; }
fail() { printf 'error: %s\n' "$*" >&2; exit 1; }

# The packages among those named that are not installed.
missing_packages() {
    local package
    for package in "$@"; do
        [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || echo "$package"
    done
}

# install_packages NAME...: install what is missing, as root or through sudo; nothing when all is there.
install_packages() {
    local missing as_root=()
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        echo "note: this is no Debian system; it must have what these Debian packages hold: $*" >&2
        return
    fi
    mapfile -t missing < <(missing_packages "$@")
    [ "${#missing[@]}" -gt 0 ] || return 0
    say "Installing ${#missing[@]} Debian packages: ${missing[*]}"
    if [ "$(id -u)" -ne 0 ]; then
        as_root=(sudo)
        [ -t 0 ] || as_root+=(-n)  # nobody is there to type a password
        command -v sudo >/dev/null && "${as_root[@]}" true 2>/dev/null ||
            fail "packages are missing and this user can install none (neither root nor sudo). Ask for:
    apt-get install --no-install-recommends ${missing[*]}"
    fi
    local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0)
    echo "(a few minutes on a fresh system)"
    "${apt[@]}" update >/dev/null || fail "apt-get update failed (its message is above): check the network and /etc/apt"
    "${apt[@]}" install --no-install-recommends "${missing[@]}" >/dev/null ||
        fail "apt-get could not install: ${missing[*]} (its message is above)"
}

# What build() configures with beside the preset; scripts that need it set it.
configure_options=()

# build PRESET [OPTION...]: configure and build.
build() {
    local preset=$1 log
    shift
    say "Building build/$preset"
    mkdir -p build
    log=build/configure-$preset.log
    cmake --preset "$preset" "${configure_options[@]}" >"$log" 2>&1 || { cat "$log" >&2; fail "cmake cannot configure the build (see above)"; }
    cmake --build --preset "$preset" "$@"
}
