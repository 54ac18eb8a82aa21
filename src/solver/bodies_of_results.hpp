#pragma once

#include <string>
#include <vector>

#include "boundary/free_body.hpp"
#include "case/case.hpp"
#include "output/results_file.hpp"
#include "particles/particles.hpp"

namespace riffle::inline solver {

/// The free bodies of a case that starts from the last state of another run (`[start] kind = "results"`), in
/// the order of the case: those that it draws as that run did go on where they were, as they moved. Empty
/// where none has moved. Throws InputError for other solids that are drawn as in that run, but stood
/// elsewhere at its end: its water does not fit them. `other`: the case of that run.
[[nodiscard]] std::vector<FreeBodyState> bodies_from_results(const Case& c, const Case& other,
                                                             const ResultsReader& results,
                                                             const std::string& file_name);

/// Throws InputError where water of that run stands in a solid at rest that it did not have.
template <int D>
void refuse_water_in_new_solids(const Case& c, const Case& other, const Particles<D>& water,
                                const std::string& file_name);

}  // namespace riffle::inline solver
