#include "boundary/round_body.hpp"

#include "case/triangle.hpp"

namespace riffle::inline boundary {

void RoundBody::clear_moment(ForceOnSolid& force, const Point3& point, const BodyState& body) const {
    const Point3 arm = body.turned({point[0] - centre[0], point[1] - centre[1], point[2] - centre[2]});
    const Point3 about_point = cross(arm, force.pressure);
    Point3 moment{};  // about the centre
    for (std::size_t k = 0; k < 3; ++k) moment[k] = force.pressure_moment[k] + about_point[k];
    if (!any_axis) {
        const Point3 along = body.turned(axis);
        const double part = along[0] * moment[0] + along[1] * moment[1] + along[2] * moment[2];
        for (std::size_t k = 0; k < 3; ++k) moment[k] = part * along[k];
    }
    for (std::size_t k = 0; k < 3; ++k) force.pressure_moment[k] -= moment[k];
}

std::optional<RoundBody> round_body(const Solid& solid) {
    const auto& c = solid.centre;
    switch (solid.shape) {
        case SolidShape::circle:
            return RoundBody{{c[0], 0.0, c[1]}, {0.0, 1.0, 0.0}, false};
        case SolidShape::sphere:
            return RoundBody{{c[0], c[1], c[2]}, {}, true};
        case SolidShape::cylinder: {
            Point3 axis{};
            axis[static_cast<std::size_t>(solid.axis)] = 1.0;
            return RoundBody{{c[0], c[1], c[2]}, axis, false};
        }
        case SolidShape::free_form:
        case SolidShape::box:
        case SolidShape::rectangle:
        case SolidShape::bed:
        case SolidShape::section:
        case SolidShape::trapezoid:
        case SolidShape::compound:
        case SolidShape::pipe:
        case SolidShape::spheres:
            break;
    }
    return std::nullopt;
}

}  // namespace riffle::inline boundary
