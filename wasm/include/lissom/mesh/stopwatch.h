#pragma once

#include <chrono>
#include <utility>

namespace lissom {

/// Seconds for the figures of a report; nothing that is computed depends on them.
class Stopwatch {
public:
    /// Since it was made or last asked.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

} // namespace lissom
