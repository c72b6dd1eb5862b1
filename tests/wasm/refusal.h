#pragma once

#include "lissom/mesh/errors.h"

#include <string>

/// The code that `work` is refused with; "none" where it is not.
template <class Work>
std::string refusal(Work&& work) {
    try {
        work();
    } catch (const lissom::InvalidInput& error) {
        return error.code();
    }
    return "none";
}
