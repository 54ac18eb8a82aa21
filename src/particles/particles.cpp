#include "particles/particles.hpp"

#include <type_traits>
#include <utility>

#include "base/parallel.hpp"

namespace riffle::inline particles {

namespace {
template <class T>
void permute_array(std::vector<T>& values, const std::vector<std::int32_t>& order, std::vector<T>& scratch) {
    scratch.resize(order.size());
    parallel_blocks(order.size(), 16384, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) scratch[i] = values[static_cast<std::size_t>(order[i])];
    });
    values.swap(scratch);
}

template <class T>
std::size_t bytes_of(const std::vector<T>& values) {
    return values.capacity() * sizeof(T);
}
}  // namespace

template <int D>
std::size_t Particles<D>::add_field(FieldInfo info) {
    further.push_back({std::move(info), {}});
    return further.size() - 1;
}

template <int D>
void Particles<D>::resize(std::size_t n) {
    for (std::size_t k = 0; k < D; ++k) {
        position[k].resize(n);
        velocity[k].resize(n);
    }
    density_deviation.resize(n);
    mass.resize(n);
    id.resize(n);
    for (FurtherField& field : further) {
        if (!field.values.empty()) field.values.resize(n);
    }
}

template <int D>
std::size_t Particles<D>::append(std::size_t n) {
    const std::size_t first = size();
    resize(first + n);
    for (std::size_t i = first; i < size(); ++i) id[i] = created++;
    return first;
}

template <int D>
void Particles<D>::permute(const std::vector<std::int32_t>& order) {
    std::vector<double> scratch;
    std::vector<std::int32_t> scratch_numbers;
    for_each_field([&](const FieldInfo&, auto& values) {
        if (values.empty()) return;
        if constexpr (std::is_same_v<decltype(values), std::vector<double>&>) {
            permute_array(values, order, scratch);
        } else {
            permute_array(values, order, scratch_numbers);
        }
    });
}

template <int D>
std::size_t Particles<D>::bytes() const {
    std::size_t total = 0;
    for_each_field([&total](const FieldInfo&, const auto& values) { total += bytes_of(values); });
    return total;
}

template <int D>
void WallParticles<D>::permute(const std::vector<std::int32_t>& order) {
    // Into arrays of their own size: those that grew while the walls were made may hold twice as much.
    for_each_array(*this, [&order](auto& values) {
        if (!values.empty()) {
            std::remove_reference_t<decltype(values)> reordered;
            permute_array(values, order, reordered);
        }
    });
}

template <int D>
std::size_t WallParticles<D>::bytes() const {
    std::size_t total = 0;
    for_each_array(*this, [&total](const auto& values) { total += bytes_of(values); });
    return total;
}

template struct WallParticles<2>;
template struct WallParticles<3>;
template struct Particles<2>;
template struct Particles<3>;

}  // namespace riffle::inline particles
