#include "roughness/bed_drag.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

#include "case/bed_traits.hpp"
#include "roughness/consistent_drag.hpp"
#include "roughness/paper_drag.hpp"
#include "roughness/sphere_drag.hpp"
#include "roughness/sphere_lattice.hpp"
#include "roughness/thesis_drag.hpp"

namespace riffle::inline roughness {

namespace {

/// A bed drag made from a coefficient that is a function of the height alone.
template <class Law>
class HeightDrag final : public BedDrag {
  public:
    HeightDrag(Law law, double top) : law_(law), top_(top) {}

    [[nodiscard]] double coefficient(double z) const override { return law_(z); }

    [[nodiscard]] double top() const override { return top_; }

  private:
    Law law_;
    double top_;
};

template <class Law>
std::unique_ptr<const BedDrag> height_drag(const Case& c, Law law) {
    return std::make_unique<HeightDrag<Law>>(law, c.bed.roughness_height);
}

/// Drag of the spheres at their places, in three dimensions: beta = phi f(z).
template <class Form>
class SphereDrag final : public BedDrag {
  public:
    SphereDrag(const Case& c, Form form) : lattice_(c), form_(form) {}

    [[nodiscard]] double coefficient(double z) const override {
        return z < 0.0 ? 0.0 : lattice_.plan_mean(z) * form_(z);
    }
    [[nodiscard]] double coefficient_at(double x, double y, double z) const override {
        const double phi = z < 0.0 ? 0.0 : lattice_.shape_factor(x, y, z);
        return phi > 0.0 ? phi * form_(z) : 0.0;
    }
    [[nodiscard]] bool varies_in_plan() const override { return true; }
    [[nodiscard]] double top() const override { return lattice_.top(); }

  private:
    SphereLattice lattice_;
    Form form_;
};

template <class Form>
std::unique_ptr<const BedDrag> sphere_drag(const Case& c, Form form) {
    return std::make_unique<SphereDrag<Form>>(c, form);
}

using Factory = std::unique_ptr<const BedDrag> (*)(const Case&);

struct Registration {
    DragForm form;
    Factory make;
};

std::unique_ptr<const BedDrag> make_consistent(const Case& c) {
    if (c.channel.dimensions == 3) {
        const double volume = volume_drag_coefficient(c.bed.drag_coefficient, c.bed.sphere_diameter);
        return sphere_drag(c, [volume](double) { return volume; });
    }
    const double spheres_per_area = c.bed.packing == Packing::hexagonal
                                        ? hexagonal_spheres_per_area(c.bed.sphere_diameter)
                                        : square_spheres_per_area(c.bed.sphere_diameter);
    return height_drag(c, [b = c.bed, spheres_per_area](double z) {
        return consistent_drag_coefficient(z, b.drag_coefficient, b.sphere_diameter, b.roughness_height,
                                           spheres_per_area);
    });
}

std::unique_ptr<const BedDrag> make_thesis(const Case& c) {
    if (c.channel.dimensions == 3) {
        const double printed = printed_sphere_drag_coefficient(c.bed.drag_coefficient, c.numerics.spacing);
        return sphere_drag(c, [printed](double) { return printed; });
    }
    return height_drag(c, [b = c.bed, spacing = c.numerics.spacing](double z) {
        return thesis_drag_coefficient(z, b.drag_coefficient, b.sphere_diameter, b.roughness_height, spacing);
    });
}

std::unique_ptr<const BedDrag> make_paper(const Case& c) {
    return height_drag(c, [b = c.bed](double z) {
        return paper_drag_coefficient(z, b.drag_coefficient, b.sphere_diameter, b.roughness_height);
    });
}

std::unique_ptr<const BedDrag> make_slice(const Case& c) {
    return sphere_drag(
        c, [b = c.bed, centre = SphereLattice(c).centre_height(), ramp = c.sphere_ramp()](double z) {
            return slice_drag_coefficient(z, b.drag_coefficient, b.sphere_diameter, centre, ramp);
        });
}

/// What the column twin takes for the consistent form, at every place of a plane.
std::unique_ptr<const BedDrag> make_plan_mean(const Case& c) {
    const SphereLattice lattice(c);
    const double volume = volume_drag_coefficient(c.bed.drag_coefficient, c.bed.sphere_diameter);
    const auto law = [lattice, volume](double z) { return z < 0.0 ? 0.0 : volume * lattice.plan_mean(z); };
    return std::make_unique<HeightDrag<decltype(law)>>(law, lattice.top());
}

/// A new drag form is one new file with its pure function and one line here.
constexpr std::array registry{
    Registration{DragForm::consistent, make_consistent}, Registration{DragForm::thesis, make_thesis},
    Registration{DragForm::paper, make_paper},           Registration{DragForm::slice, make_slice},
    Registration{DragForm::plan_mean, make_plan_mean},
};

}  // namespace

std::unique_ptr<const BedDrag> make_bed_drag(const Case& c) {
    if (!has_spheres(c.bed)) return nullptr;
    const auto* const entry = std::find_if(registry.begin(), registry.end(),
                                           [&c](const Registration& r) { return r.form == c.bed.drag_form; });
    assert(entry != registry.end());
    return entry->make(c);
}

}  // namespace riffle::inline roughness
