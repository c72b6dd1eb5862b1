#pragma once

#include "lissom/hair/style.h"

#include <vector>

namespace lissom {

/// How a strand meets the first cross-section C1 of a ponytail.
struct TailPassage {
    bool reaches = false; ///< rooted before its plane and comes within three radii: the strand is of its region
    bool passes = false;  ///< crosses it along its axis, no farther out than 1.3 radii, where the pull begins (Fu 4.5)
    int at = -1;          ///< the first point beyond the plane
};
[[nodiscard]] TailPassage passage_of(const std::vector<Eigen::Vector3d>& points, const TailSection& section);

/// The ties of a style's ponytails: what passes one is drawn together there, and lies tight as far as it.
class TailTie {
public:
    /// @param sections  C1 of each ponytail; those of radius 0 tie nothing
    explicit TailTie(std::vector<TailSection> sections) : sections_(std::move(sections)) {}

    [[nodiscard]] const std::vector<TailSection>& sections() const { return sections_; }

    /// How loose detail may be at each point of a strand, 0..1: little up to a tie, all of it beyond.
    [[nodiscard]] std::vector<double> looseness(const std::vector<Eigen::Vector3d>& points, double segment) const;

    /// Draws a strand that crosses a tie's plane anywhere near it together with the others there; its root stays.
    void draw(std::vector<Eigen::Vector3d>& points) const;

private:
    std::vector<TailSection> sections_;
};

} // namespace lissom
