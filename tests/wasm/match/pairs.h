#pragma once

// Pairs of shared models of which it is known what belongs to what.

#include "lissom/match/match_session.h"

#include <map>
#include <string>
#include <vector>

namespace pairs {

/// Named vertices that the file beside a family of models lists; none where it is not there.
[[nodiscard]] std::map<std::string, int> landmarks(const std::string& name);

/// These vertices of a mesh as places.
[[nodiscard]] lissom::Points places(const lissom::TriangleMesh& mesh, const std::vector<int>& vertices);

struct Matched {
    lissom::MatchResult result;
    double seconds = 0;
};
[[nodiscard]] Matched run(const lissom::TriangleMesh& source, const lissom::TriangleMesh& target, const lissom::Points& from, const lissom::Points& to, const lissom::MatchOptions& options = {});

/// Any number of models at once, the source first.
[[nodiscard]] Matched run(const std::vector<lissom::TriangleMesh>& models, const std::vector<lissom::Points>& markers, const lissom::MatchOptions& options = {});

/// The same by pairs, composed: before and after the projections.
struct ByPairs {
    lissom::MatchResult composed;
    Matched projected;
};
[[nodiscard]] ByPairs run_by_pairs(const std::vector<lissom::TriangleMesh>& models, const std::vector<lissom::Points>& markers);

/// How far the target's skin is from the truth, as shares of the target's diagonal, over samples of the source's skin that each stand for the same area.
struct Error {
    double mean, most;
};
/// @param source,target  two members of a family: vertex i is vertex i; the skins lie on them
/// @param from,to  which of the skins lie on them
[[nodiscard]] Error error(const lissom::SkinSet& skins, const lissom::TriangleMesh& source, const lissom::TriangleMesh& target, int from = 0, int to = 1);

/// One line of figures.
[[nodiscard]] std::string figures(const Matched& matched);

} // namespace pairs
