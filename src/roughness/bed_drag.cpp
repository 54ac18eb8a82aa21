#include "roughness/bed_drag.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

#include "roughness/consistent_drag.hpp"
#include "roughness/paper_drag.hpp"
#include "roughness/thesis_drag.hpp"

namespace riffle {

namespace {

/// A bed drag made from a coefficient that is a function of the height alone.
template <class Law>
class HeightDrag final : public BedDrag {
  public:
    HeightDrag(Law law, double top) : law_(law), top_(top) {}

    [[nodiscard]] double coefficient(double z) const override { return law_(z); }

    [[nodiscard]] double top() const override { return top_; }

    void coefficients(std::span<const double> z, std::span<double> result) const override {
        assert(result.size() == z.size());
        for (std::size_t i = 0; i < z.size(); ++i) result[i] = law_(z[i]);
    }

  private:
    Law law_;
    double top_;
};

template <class Law>
std::unique_ptr<const BedDrag> height_drag(const Case& c, Law law) {
    return std::make_unique<HeightDrag<Law>>(law, c.bed.roughness_height);
}

using Factory = std::unique_ptr<const BedDrag> (*)(const Case&);

struct Registration {
    DragForm form;
    Factory make;
};

std::unique_ptr<const BedDrag> make_consistent(const Case& c) {
    const double spheres_per_area = c.bed.packing == Packing::hexagonal
                                        ? hexagonal_spheres_per_area(c.bed.sphere_diameter)
                                        : square_spheres_per_area(c.bed.sphere_diameter);
    return height_drag(c, [b = c.bed, spheres_per_area](double z) {
        return consistent_drag_coefficient(z, b.drag_coefficient, b.sphere_diameter, b.roughness_height,
                                           spheres_per_area);
    });
}

std::unique_ptr<const BedDrag> make_thesis(const Case& c) {
    return height_drag(c, [b = c.bed, spacing = c.numerics.spacing](double z) {
        return thesis_drag_coefficient(z, b.drag_coefficient, b.sphere_diameter, b.roughness_height, spacing);
    });
}

std::unique_ptr<const BedDrag> make_paper(const Case& c) {
    return height_drag(c, [b = c.bed](double z) {
        return paper_drag_coefficient(z, b.drag_coefficient, b.sphere_diameter, b.roughness_height);
    });
}

/// A new drag form is one new file with its pure function and one line here.
constexpr std::array registry{
    Registration{DragForm::consistent, make_consistent},
    Registration{DragForm::thesis, make_thesis},
    Registration{DragForm::paper, make_paper},
};

}  // namespace

std::unique_ptr<const BedDrag> make_bed_drag(const Case& c) {
    if (c.bed.kind != BedKind::spheres) return nullptr;
    const auto* const entry = std::find_if(registry.begin(), registry.end(),
                                           [&c](const Registration& r) { return r.form == c.bed.drag_form; });
    assert(entry != registry.end());
    return entry->make(c);
}

}  // namespace riffle
