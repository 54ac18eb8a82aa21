#include "walls/wall_treatment.hpp"

#include "walls/dummy_walls.hpp"
#include "walls/dynamic_walls.hpp"
#include "walls/ghost_walls.hpp"

namespace riffle::inline walls {

template <int D, class Real>
std::unique_ptr<WallTreatment<D, Real>> make_wall_treatment(const Case& c) {
    switch (c.numerics.wall) {
        case WallKind::dynamic:
            return std::make_unique<DynamicWalls<D, Real>>(c);
        case WallKind::modified_dynamic:
            return std::make_unique<GhostWalls<D, Real>>(c);
        case WallKind::dummy:
        case WallKind::repulsive:  // a component pushes; there are no particles
            return std::make_unique<DummyWalls<D, Real>>(c);
    }
    return nullptr;
}

template std::unique_ptr<WallTreatment<2, float>> make_wall_treatment(const Case&);
template std::unique_ptr<WallTreatment<2, double>> make_wall_treatment(const Case&);
template std::unique_ptr<WallTreatment<3, float>> make_wall_treatment(const Case&);
template std::unique_ptr<WallTreatment<3, double>> make_wall_treatment(const Case&);

}  // namespace riffle::inline walls
