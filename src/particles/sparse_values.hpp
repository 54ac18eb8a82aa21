#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace riffle::inline particles {

/// A value for each particle that is zero for most: memory is taken for short runs of particles only, of
/// which one has another value. Values of different particles may be set by several threads at a time.
class SparseValues {
  public:
    SparseValues() = default;
    ~SparseValues() { release(); }
    SparseValues(const SparseValues&) = delete;
    SparseValues& operator=(const SparseValues&) = delete;

    /// Let the values of so many particles be zero.
    void reset(std::size_t particles) {
        release();
        size_ = particles;
        runs_ = std::make_unique<std::atomic<Run*>[]>(run_count());
    }
    /// Forget the particles.
    void release() {
        for (std::size_t i = 0; i < run_count(); ++i) {
            delete runs_[i].load();  // NOLINT(cppcoreguidelines-owning-memory)
        }
        runs_.reset();
        size_ = 0;
    }

    void set(std::size_t particle, double value) {
        if (value != 0.0) run_of(particle)[particle % run_length] = value;
    }
    [[nodiscard]] double operator[](std::size_t particle) const {
        const Run* const run = runs_[particle / run_length].load(std::memory_order_acquire);
        return run != nullptr ? (*run)[particle % run_length] : 0.0;
    }
    [[nodiscard]] std::size_t size() const { return size_; }

    /// Keep those of these particles alone, in this order.
    void keep(const std::vector<std::int32_t>& particles) {
        if (size_ == 0) return;
        SparseValues before;
        std::swap(runs_, before.runs_);
        std::swap(size_, before.size_);
        reset(particles.size());
        for (std::size_t i = 0; i < particles.size(); ++i) {
            set(i, before[static_cast<std::size_t>(particles[i])]);
        }
    }

    [[nodiscard]] std::size_t bytes() const {
        std::size_t taken = run_count() * sizeof(Run*);
        for (std::size_t i = 0; i < run_count(); ++i) taken += runs_[i].load() != nullptr ? sizeof(Run) : 0;
        return taken;
    }

  private:
    static constexpr std::size_t run_length = 16;
    using Run = std::array<double, run_length>;

    [[nodiscard]] std::size_t run_count() const { return (size_ + run_length - 1) / run_length; }
    Run& run_of(std::size_t particle) {
        std::atomic<Run*>& place = runs_[particle / run_length];
        Run* run = place.load(std::memory_order_acquire);
        if (run == nullptr) {
            auto fresh = std::make_unique<Run>();
            // Another thread may have been faster; then `run` is its one.
            if (place.compare_exchange_strong(run, fresh.get(), std::memory_order_acq_rel)) {
                run = fresh.release();
            }
        }
        return *run;
    }

    std::unique_ptr<std::atomic<Run*>[]> runs_;  // NOLINT(*-avoid-c-arrays)
    std::size_t size_ = 0;
};

}  // namespace riffle::inline particles
