#include "lissom/merge/merged_model.h"

#include "lissom/mesh/topology.h"

#include <algorithm>
#include <map>
#include <utility>

namespace lissom {
namespace {

/// One file's side of the joined mesh.
class Side {
public:
    Side(const JoinedMesh& joined, const Part& part, const WorkingMesh& working, bool is_source)
        : joined_(joined), part_(part), working_(working), is_source_(is_source) {
        const int polygons = working.polygon_of_display.empty() ? 0 : 1 + *std::max_element(working.polygon_of_display.begin(), working.polygon_of_display.end());
        first_.assign(static_cast<std::size_t>(polygons) + 1, 0);
        for (const int p : working.polygon_of_display) ++first_[p + 1];
        for (int p = 0; p < polygons; ++p) first_[p + 1] += first_[p];
        // A polygon goes in whole when every working triangle of it is still there, uncut.
        std::vector<int> missing(static_cast<std::size_t>(polygons), 0), a_triangle(static_cast<std::size_t>(polygons), -1);
        for (const int p : working.polygon_of_triangle) ++missing[p];
        for_own([&](int t) {
            if (!is_intact(t)) return;
            --missing[polygon(t)];
            a_triangle[polygon(t)] = t;
        });
        is_whole_.assign(static_cast<std::size_t>(polygons), 0);
        for (int p = 0; p < polygons; ++p)
            if (a_triangle[p] >= 0 && missing[p] == 0) {
                is_whole_[p] = 1;
                contribution.faces.push_back(p);
                contribution.turned.push_back(is_turned(p, a_triangle[p]));
            }
        contribution.result_of_vertex.assign(working.working_of_source.size(), -1);
        part_of_working_.assign(static_cast<std::size_t>(working.mesh.vertex_count()), -1);
        for (int v = 0; v < std::ssize(part.origin); ++v)
            if (part.origin[v].is_vertex()) part_of_working_[part.origin[v].vertex[0]] = v;
    }

    /// Marks the file vertices that the result needs; those that became a target vertex stand for nothing of their own.
    void mark_used(std::vector<char>& used) const {
        used.assign(working_.working_of_source.size(), 0);
        for (const int p : contribution.faces)
            for (int d = first_[p]; d < first_[p + 1]; ++d)
                for (int c = 0; c < 3; ++c) used[working_.display(d, c)] = 1;
        for_own([&](int t) {
            if (is_whole_[polygon(t)]) return;
            for (int c = 0; c < 3; ++c)
                if (const Origin o = corner(t, c); o.is_vertex()) used[file_vertex(polygon(t), o.vertex[0])] = 1;
        });
    }

    [[nodiscard]] int joined_vertex(int part_vertex) const { return is_source_ ? joined_.vertex_of_source[part_vertex] : part_vertex; }
    [[nodiscard]] int part_vertex_of_file(int v) const {
        const int w = working_.working_of_source[v];
        return w < 0 ? -1 : part_of_working_[w];
    }

    /// The polygon's own copy of a working vertex; the first of all where the polygon has none.
    [[nodiscard]] int file_vertex(int p, int working_vertex) const {
        for (int d = first_[p]; d < first_[p + 1]; ++d)
            for (int c = 0; c < 3; ++c)
                if (working_.working_of_source[working_.display(d, c)] == working_vertex) return working_.display(d, c);
        return working_.source_of_working[working_vertex];
    }

    [[nodiscard]] Origin in_file(const Origin& o, int p) const {
        Origin result = o;
        for (int& v : result.vertex) v = p < 0 ? working_.source_of_working[v] : file_vertex(p, v);
        return result;
    }

    template <class Visit>
    void for_cut(Visit visit) const {
        for_own([&](int t) {
            if (!is_whole_[polygon(t)]) visit(t, polygon(t));
        });
    }

    /// Where a corner lies on the input, in working vertices.
    [[nodiscard]] Origin corner(int t, int c) const {
        if (joined_.made[t] >= 0) return joined_.made_corners[joined_.made[t]][c];
        const int part_triangle = joined_.part_triangle[t];
        for (int k = 0; k < 3; ++k)
            if (joined_vertex(part_.mesh.triangles(part_triangle, k)) == joined_.mesh.triangles(t, c)) return part_.origin[part_.mesh.triangles(part_triangle, k)];
        return {};
    }

    Contribution contribution;

private:
    template <class Visit>
    void for_own(Visit visit) const {
        for (int t = 0; t < joined_.mesh.triangle_count(); ++t)
            if (static_cast<bool>(joined_.from_source[t]) == is_source_) visit(t);
    }
    [[nodiscard]] bool is_intact(int t) const { return joined_.made[t] < 0 && part_.is_whole[joined_.part_triangle[t]]; }
    [[nodiscard]] int polygon(int t) const { return working_.polygon_of_triangle[part_.triangle_origin[joined_.part_triangle[t]]]; }

    /// Whether the joined triangle runs against the polygon's own direction.
    [[nodiscard]] bool is_turned(int p, int t) const {
        int w[3];
        for (int c = 0; c < 3; ++c) w[c] = corner(t, c).vertex[0];
        for (int d = first_[p]; d < first_[p + 1]; ++d)
            for (int c = 0; c < 3; ++c) {
                const auto at = [&](int k) { return working_.working_of_source[working_.display(d, (c + k) % 3)]; };
                if (at(0) == w[0] && at(1) == w[1] && at(2) == w[2]) return false;
                if (at(0) == w[0] && at(1) == w[2] && at(2) == w[1]) return true;
            }
        return false;
    }

    const JoinedMesh& joined_;
    const Part& part_;
    const WorkingMesh& working_;
    const bool is_source_;
    std::vector<int> first_; ///< of each polygon's display triangles
    std::vector<char> is_whole_;
    std::vector<int> part_of_working_;
};

} // namespace

MergedModel to_files(const JoinedMesh& joined, const Part& target_part, const WorkingMesh& target, const Part& source_part,
                     const WorkingMesh& source, const std::vector<char>& moved) {
    MergedModel out;
    std::vector<Eigen::RowVector3d> positions;
    std::vector<int> result_of_joined(static_cast<std::size_t>(joined.mesh.vertex_count()), -1); // a representative
    const auto place = [&](int v) -> Eigen::RowVector3d {
        return target.to_source(joined.mesh.points.row(v).transpose()).transpose();
    };

    Side own(joined, target_part, target, false), other(joined, source_part, source, true);
    std::vector<char> used;
    own.mark_used(used);
    for (int v = 0; v < std::ssize(used); ++v) {
        if (!used[v]) continue;
        const int p = own.part_vertex_of_file(v);
        own.contribution.result_of_vertex[v] = static_cast<int>(positions.size());
        if (result_of_joined[p] < 0) result_of_joined[p] = static_cast<int>(positions.size());
        positions.push_back(moved[p] ? Eigen::RowVector3d(place(p)) : Eigen::RowVector3d(target.source.row(v)));
    }
    other.mark_used(used);
    for (int v = 0; v < std::ssize(used); ++v) {
        if (!used[v]) continue;
        const int j = other.joined_vertex(other.part_vertex_of_file(v));
        if (j < joined.target_vertices) continue; // see below: it may have become a vertex yet to be made
        other.contribution.result_of_vertex[v] = static_cast<int>(positions.size());
        if (result_of_joined[j] < 0) result_of_joined[j] = static_cast<int>(positions.size());
        positions.emplace_back(place(j));
    }
    const auto make_new = [&](int j, const Origin& origin, bool from_source) {
        result_of_joined[j] = static_cast<int>(positions.size());
        positions.emplace_back(place(j));
        out.new_from_source.push_back(from_source);
        out.new_origin.push_back(origin);
    };
    for (const Side* side : {&own, &other})
        side->for_cut([&](int t, int p) {
            for (int c = 0; c < 3; ++c) {
                const int j = joined.mesh.triangles(t, c);
                if (result_of_joined[j] >= 0) continue;
                const bool from_target = j < joined.target_vertices;
                // A seam vertex of the other part gets its attributes from there, where it is a vertex.
                const Part& part = from_target ? target_part : source_part;
                const bool at_home = from_target == (side == &own);
                const Origin& origin = part.origin[from_target ? j : j - joined.target_vertices];
                make_new(j, (from_target ? own : other).in_file(origin, at_home ? p : -1), !from_target);
            }
        });
    other.mark_used(used);
    for (int v = 0; v < std::ssize(used); ++v)
        if (used[v] && other.contribution.result_of_vertex[v] < 0) {
            const int j = other.joined_vertex(other.part_vertex_of_file(v));
            if (result_of_joined[j] < 0) make_new(j, own.in_file(target_part.origin[j], -1), false);
            other.contribution.result_of_vertex[v] = result_of_joined[j];
        }
    for (const Side* side : {&own, &other})
        side->for_cut([&](int t, int p) {
            for (int c = 0; c < 3; ++c) {
                const int j = joined.mesh.triangles(t, c);
                const Origin origin = side->corner(t, c), in_file = side->in_file(origin, p);
                int vertex = result_of_joined[j];
                if (origin.is_vertex())
                    if (const int copy = side->contribution.result_of_vertex[in_file.vertex[0]]; copy >= 0) vertex = copy;
                out.cut_vertices.push_back(vertex);
                out.cut_corners.push_back(in_file);
            }
            out.cut_from_source.push_back(side == &other);
            out.cut_face.push_back(p);
        });
    for (const std::vector<int>& seam : joined.seams) {
        auto& list = out.seams.emplace_back();
        for (const int j : seam) list.push_back(result_of_joined[j]);
    }
    out.positions.resize(std::ssize(positions), 3);
    for (std::size_t v = 0; v < positions.size(); ++v) out.positions.row(static_cast<Eigen::Index>(v)) = positions[v];
    out.euler_characteristic = euler_characteristic(joined.mesh);
    out.target = std::move(own.contribution);
    out.source = std::move(other.contribution);
    return out;
}

} // namespace lissom
