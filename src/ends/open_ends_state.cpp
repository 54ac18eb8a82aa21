#include "ends/open_ends_state.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

namespace riffle::inline ends {

namespace {

/// f(number) for each number of an end.
template <class End, class F>
void for_each_number(End& end, const F& f) {
    for (auto* const number : {&end.watched_depth, &end.watched_velocity, &end.watched_pressure, &end.depth,
                               &end.velocity, &end.depth_rate, &end.pressure, &end.coming}) {
        f(*number);
    }
}

template <class Ledger, class F>
void for_each_amount(Ledger& ledger, const F& f) {
    for (auto* const amount :
         {&ledger.mass_entered, &ledger.mass_left, &ledger.momentum_entered, &ledger.momentum_left}) {
        f(*amount);
    }
}

constexpr std::size_t fixed_numbers = 25;

/// A balance of particles among numbers of a state.
std::int64_t balance_of(double number) {
    if (!(std::abs(number) < 9e15 && number == std::floor(number))) {
        throw std::invalid_argument("a count of the open ends is no whole number");
    }
    return static_cast<std::int64_t>(number);
}

/// A count among numbers of a state.
std::size_t count_of(double number) {
    const std::int64_t count = balance_of(number);
    if (count < 0) throw std::invalid_argument("a count of the open ends is below zero");
    return static_cast<std::size_t>(count);
}

}  // namespace

std::vector<double> OpenEndsState::numbers() const {
    std::vector<double> all;
    if (!begun) return all;
    const auto add = [&all](double number) { all.push_back(number); };
    add(travel);
    add(rows);
    add(static_cast<double>(ledger.entered));
    add(static_cast<double>(ledger.left));
    add(static_cast<double>(leaving.size()));
    for_each_amount(ledger, add);
    for_each_number(upstream, add);
    for_each_number(downstream, add);
    all.insert(all.end(), leaving.begin(), leaving.end());
    all.insert(all.end(), front.begin(), front.end());
    return all;
}

OpenEndsState OpenEndsState::from(const std::vector<double>& numbers) {
    OpenEndsState state;
    if (numbers.empty()) return state;
    if (numbers.size() < fixed_numbers) {
        throw std::invalid_argument("too few numbers for the state of open ends");
    }
    std::size_t next = 0;
    const auto take = [&](double& number) { number = numbers[next++]; };
    std::array<double, 4> whole{};
    take(state.travel);
    for (double& number : whole) take(number);
    state.rows = static_cast<int>(count_of(whole[0]));
    state.ledger.entered = balance_of(whole[1]);
    state.ledger.left = static_cast<std::int64_t>(count_of(whole[2]));
    const std::size_t bins = count_of(whole[3]);
    for_each_amount(state.ledger, take);
    for_each_number(state.upstream, take);
    for_each_number(state.downstream, take);
    if (bins > numbers.size() - next) {
        throw std::invalid_argument("the profile of the water that leaves is cut off");
    }
    const auto streams = numbers.begin() + static_cast<std::ptrdiff_t>(next + bins);
    state.leaving.assign(numbers.begin() + static_cast<std::ptrdiff_t>(next), streams);
    state.front.assign(streams, numbers.end());
    if (state.rows == 0 || state.front.size() % static_cast<std::size_t>(state.rows) != 0) {
        throw std::invalid_argument("the streams of the inflow do not fill its rows");
    }
    state.begun = true;
    return state;
}

std::vector<double> OpenEndsState::sound_numbers() const {
    std::vector<double> all;
    for (const SoundBeyondEnd* const sound : {&sound_upstream, &sound_downstream}) {
        for (const auto* const values : {&sound->slow, &sound->now, &sound->change}) {
            all.push_back(static_cast<double>(values->size()));
            all.insert(all.end(), values->begin(), values->end());
        }
    }
    return all;
}

void OpenEndsState::take_sound(const std::vector<double>& numbers) {
    std::size_t next = 0;
    for (SoundBeyondEnd* const sound : {&sound_upstream, &sound_downstream}) {
        for (auto* const values : {&sound->slow, &sound->now, &sound->change}) {
            const std::size_t count = next < numbers.size() ? count_of(numbers[next]) : numbers.size();
            if (next >= numbers.size() || count > numbers.size() - next - 1) {
                throw std::invalid_argument("the sound at the open ends is cut off");
            }
            const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(next) + 1;
            values->assign(first, first + static_cast<std::ptrdiff_t>(count));
            next += count + 1;
        }
    }
    if (next != numbers.size()) throw std::invalid_argument("the sound at the open ends has more numbers");
}

}  // namespace riffle::inline ends
