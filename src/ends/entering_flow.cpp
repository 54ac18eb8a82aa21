#include "ends/entering_flow.hpp"

namespace riffle::inline ends {

double EnteringFlow::mean_of_streams(double time, int rows, std::span<const double> files) const {
    double sum = 0.0;
    for (int row = 0; row < rows; ++row) {
        for (const double y : files) sum += at(time, y, (row + 0.5) / rows)[0];
    }
    return sum / (rows * static_cast<double>(files.size()));
}

}  // namespace riffle::inline ends
