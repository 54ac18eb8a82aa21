#include "base/parallel.hpp"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <atomic>
#include <vector>

#include "base/error.hpp"

namespace riffle::parallel_test {
namespace {

TEST(ParallelBlocks, VisitEveryIndexOnce) {
    set_thread_count(2);
    EXPECT_TRUE(rc::check("blocks cover [0, n) once, and none is longer than asked", [] {
        const auto n = *rc::gen::inRange<std::size_t>(0, 5000);
        const auto block = *rc::gen::inRange<std::size_t>(1, 700);
        std::vector<std::atomic<int>> visits(n);
        std::atomic<bool> too_long{false};
        parallel_blocks(n, block, [&](std::size_t begin, std::size_t end) {
            if (end <= begin || end > n || (n > block && end - begin > block)) too_long = true;
            for (std::size_t i = begin; i < end; ++i) ++visits[i];
        });
        RC_ASSERT(!too_long);
        for (const auto& count : visits) RC_ASSERT(count == 1);
    }));
}

// Sums of numbers of very different size depend on the order of summation: equal bits show the fixed order.
TEST(ReduceBlocks, GivesTheSameBitsForAnyNumberOfThreads) {
    std::vector<double> values(100000);
    double x = 0.5;
    for (double& value : values) {
        x = 3.9 * x * (1.0 - x);
        value = (x - 0.5) / (x * x * x * x + 1e-12);
    }
    const auto sum = [&] {
        return reduce_blocks(
            values.size(), std::size_t{64}, 0.0,
            [&](std::size_t begin, std::size_t end) {
                double part = 0.0;
                for (std::size_t i = begin; i < end; ++i) part += values[i];
                return part;
            },
            [](double a, double b) { return a + b; });
    };
    set_thread_count(1);
    const double one = sum();
    for (const int threads : {2, 3, 4}) {
        set_thread_count(threads);
        EXPECT_EQ(thread_count(), threads);
        for (int repetition = 0; repetition < 5; ++repetition) EXPECT_EQ(sum(), one);
    }
    set_thread_count(1);
}

TEST(ReduceBlocks, OfNothingIsTheIdentity) {
    const double result = reduce_blocks(
        std::size_t{0}, std::size_t{8}, 7.0, [](std::size_t, std::size_t) { return 1.0; },
        [](double a, double b) { return a + b; });
    EXPECT_EQ(result, 7.0);
}

// The exit status of the command follows from the type of the error (docs/user-guide.md).
TEST(Errors, CarryTheirExitStatus) {
    EXPECT_EQ(InputError("x").code(), ExitCode::bad_input);
    EXPECT_EQ(FileError("x").code(), ExitCode::file_error);
    EXPECT_EQ(RunError("x").code(), ExitCode::run_failed);
    EXPECT_STREQ(InputError("what is wrong").what(), "what is wrong");
}

}  // namespace
}  // namespace riffle::parallel_test
