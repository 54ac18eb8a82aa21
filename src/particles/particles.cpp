#include "particles/particles.hpp"

#include <type_traits>

#include "base/parallel.hpp"

namespace riffle {

namespace {
template <class T>
void permute_array(std::vector<T>& values, const std::vector<std::int32_t>& order, std::vector<T>& scratch) {
    scratch.resize(order.size());
    parallel_blocks(order.size(), 16384, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            scratch[i] = values[static_cast<std::size_t>(order[i])];
        }
    });
    values.swap(scratch);
}
}  // namespace

template <int D>
void Particles<D>::permute(const std::vector<std::int32_t>& order) {
    std::vector<double> scratch;
    for (std::size_t k = 0; k < D; ++k) {
        permute_array(position[k], order, scratch);
        permute_array(velocity[k], order, scratch);
    }
    permute_array(density_deviation, order, scratch);
    permute_array(mass, order, scratch);
    if (!previous.empty()) {
        for (auto& component : previous.motion) {
            permute_array(component, order, scratch);
        }
        permute_array(previous.density, order, scratch);
    }
    std::vector<std::int32_t> scratch_id;
    permute_array(id, order, scratch_id);
}

template <int D>
void WallParticles<D>::permute(const std::vector<std::int32_t>& order) {
    // Into arrays of their own size: those that grew while the walls were made may hold twice as much.
    const auto reorder = [&](auto& values) {
        std::remove_reference_t<decltype(values)> reordered;
        permute_array(values, order, reordered);
    };
    for (std::size_t k = 0; k < D; ++k) {
        reorder(position[k]);
        reorder(normal[k]);
    }
    for (auto& component : projector) {
        reorder(component);
    }
    reorder(volume);
    reorder(depth);
    if (!body.empty()) {
        reorder(body);
    }
}

template struct WallParticles<2>;
template struct WallParticles<3>;
template struct Particles<2>;
template struct Particles<3>;

}  // namespace riffle
