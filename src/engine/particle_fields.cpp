#include "engine/particle_fields.hpp"

#include <array>

namespace riffle::inline engine {

std::span<SparseValues ParticleFields::*const> ParticleFields::near_walls(int dimensions) {
    static constexpr std::array<SparseValues ParticleFields::*, 8> all = {
        &ParticleFields::wall_acceleration_x,      &ParticleFields::wall_acceleration_z,
        &ParticleFields::drag_acceleration_x,      &ParticleFields::vegetation_acceleration_x,
        &ParticleFields::porous_acceleration_x,    &ParticleFields::drag_acceleration_y,
        &ParticleFields::side_wall_acceleration_x, &ParticleFields::side_wall_acceleration_z};
    return std::span(all).first(dimensions == 3 ? all.size() : 5);
}

template <class Self, class F>
void ParticleFields::for_each(Self& self, const F& f) {
    f(self.pressure);
    f(self.shear);
    f(self.regularity);
    f(self.pair_acceleration_x);
    f(self.viscous_acceleration_x);
    f(self.shear_stress);
    f(self.lateral_shear_stress);
    for (SparseValues ParticleFields::*const force : near_walls(3)) f(self.*force);
}

namespace {

template <class Values>
void release_values(Values& values) {
    values.release();
}
void release_values(std::vector<double>& values) { std::vector<double>().swap(values); }

template <class Values>
void keep_values(Values& values, const std::vector<std::int32_t>& particles) {
    values.keep(particles);
}
void keep_values(std::vector<double>& values, const std::vector<std::int32_t>& particles) {
    WorkingValues::keep_values(values, particles);
}

template <class Values>
std::size_t bytes_of(const Values& values) {
    return values.bytes();
}
std::size_t bytes_of(const std::vector<double>& values) { return values.capacity() * sizeof(double); }

}  // namespace

void ParticleFields::release(bool with_viscosity) {
    for_each(*this, [](auto& values) { release_values(values); });
    if (with_viscosity) eddy_viscosity.release();
}

void ParticleFields::keep(const std::vector<std::int32_t>& particles, std::size_t out_of) {
    const auto keep_or_free = [&](auto& values) {
        if (values.size() == out_of) {
            keep_values(values, particles);
        } else {
            release_values(values);
        }
    };
    for_each(*this, keep_or_free);
    keep_or_free(eddy_viscosity);
}

std::size_t ParticleFields::bytes() const {
    std::size_t total = eddy_viscosity.bytes();
    for_each(*this, [&](const auto& values) { total += bytes_of(values); });
    return total;
}

}  // namespace riffle::inline engine
