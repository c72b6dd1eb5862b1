#pragma once

// The arguments of the benchmark programs. `npm run bench` hands the same ones to all of them, so each knows
// every option and reads its own.

#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace bench {

class Options {
public:
    /// Ends the program with a sentence on an option that none of them has, or one without a value.
    Options(int argc, char** argv) {
        for (int a = 1; a < argc; a += 2) {
            const std::string name = argv[a];
            const bool known = name == "--vertices" || name == "--repeat" || name == "--no-eigen-above" || name == "--grids" ||
                               name == "--constraints" || name == "--strands" || name == "--changed" || name == "--rings" ||
                               name == "--no-sparse-above" || name == "--no-full-above" || name == "--handles";
            if (!known || a + 1 == argc) {
                std::fprintf(stderr, "%s: %s option %s\n", argv[0], known ? "no value for" : "unknown", argv[a]);
                std::exit(1);
            }
            given_[name] = argv[a + 1];
        }
    }

    [[nodiscard]] int number(const std::string& name, int otherwise) const {
        const auto found = given_.find(name);
        return found == given_.end() ? otherwise : std::atoi(found->second.c_str());
    }

    /// Numbers with commas between them.
    [[nodiscard]] std::vector<int> numbers(const std::string& name, const std::string& otherwise) const {
        const auto found = given_.find(name);
        std::istringstream list(found == given_.end() ? otherwise : found->second);
        std::vector<int> out;
        for (std::string part; std::getline(list, part, ',');) out.push_back(std::atoi(part.c_str()));
        return out;
    }

private:
    std::map<std::string, std::string> given_;
};

} // namespace bench
