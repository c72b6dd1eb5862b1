#pragma once

#include <stdexcept>
#include <string>

namespace lissom {

/// The caller can mend it: what happened, where, what to do. `code` is stable and kebab-case.
class InvalidInput : public std::runtime_error {
public:
    InvalidInput(std::string code, const std::string& message)
        : std::runtime_error(message), code_(std::move(code)) {}
    [[nodiscard]] const std::string& code() const { return code_; }

private:
    std::string code_;
};

/// The numbers refused: names pivot, column and size. Never a NaN in a result instead.
class SolverFailure : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

} // namespace lissom
