#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

namespace shapes {

namespace {

constexpr double k_pi = std::numbers::pi;

/// Collects vertices and triangles while a shape is drawn.
struct Draft {
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector3i> triangles;

    int point(const Eigen::Vector3d& p) {
        points.push_back(p);
        return static_cast<int>(points.size()) - 1;
    }
    void triangle(int a, int b, int c) { triangles.emplace_back(a, b, c); }
    void quad(int a, int b, int c, int d) {
        triangle(a, b, c);
        triangle(a, c, d);
    }
    [[nodiscard]] TriangleMesh mesh() const {
        TriangleMesh made{Points(points.size(), 3), Triangles(triangles.size(), 3)};
        for (std::size_t i = 0; i < points.size(); ++i)
            made.points.row(static_cast<int>(i)) = points[i];
        for (std::size_t t = 0; t < triangles.size(); ++t)
            made.triangles.row(static_cast<int>(t)) = triangles[t];
        return made;
    }
};

/// Vertices at the corners of a lattice, each made when first asked for.
struct Lattice {
    Draft& draft;
    Eigen::Vector3d step, origin;
    std::map<std::tuple<int, int, int>, int> ids;

    int operator()(int i, int j, int k) {
        const auto [place, is_new] = ids.try_emplace({i, j, k}, static_cast<int>(draft.points.size()));
        if (is_new)
            draft.point(origin + step.cwiseProduct(Eigen::Vector3d(i, j, k)));
        return place->second;
    }
};

} // namespace

TriangleMesh box(int nx, int ny, int nz, const Eigen::Vector3d& size) {
    Draft draft;
    Lattice at{draft, size.cwiseQuotient(Eigen::Vector3d(nx, ny, nz)), {-size.x() / 2, 0, -size.z() / 2}, {}};
    const auto side = [&](int n, int m, auto corner) {
        for (int a = 0; a < n; ++a)
            for (int b = 0; b < m; ++b) {
                const int p = corner(a, b), q = corner(a + 1, b), r = corner(a + 1, b + 1), s = corner(a, b + 1);
                if ((a + b) % 2)
                    draft.quad(p, q, r, s);
                else
                    draft.quad(q, r, s, p);
            }
    };
    side(nx, ny, [&](int a, int b) { return at(a, b, nz); });
    side(ny, nx, [&](int a, int b) { return at(b, a, 0); });
    side(ny, nz, [&](int a, int b) { return at(nx, a, b); });
    side(nz, ny, [&](int a, int b) { return at(0, b, a); });
    side(nz, nx, [&](int a, int b) { return at(b, ny, a); });
    side(nx, nz, [&](int a, int b) { return at(a, 0, b); });
    return draft.mesh();
}

TriangleMesh bar() { return box(8, 60, 8, {1, 8, 1}); }

TriangleMesh uv_sphere(int parallels, int meridians) {
    Draft draft;
    for (int i = 1; i < parallels; ++i)
        for (int j = 0; j < meridians; ++j) {
            const double theta = k_pi * i / parallels, phi = 2 * k_pi * j / meridians;
            draft.point({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
        }
    const int north = draft.point({0, 0, 1}), south = draft.point({0, 0, -1});
    for (int j = 0; j < meridians; ++j) {
        const int next = (j + 1) % meridians, last = (parallels - 2) * meridians;
        draft.triangle(north, j, next);
        for (int row = 0; row < last; row += meridians)
            draft.quad(row + j, row + meridians + j, row + meridians + next, row + next);
        draft.triangle(south, last + next, last + j);
    }
    return draft.mesh();
}

TriangleMesh icosphere(int levels) {
    Draft draft;
    const double t = std::numbers::phi;
    for (const Eigen::Vector3d& p : std::vector<Eigen::Vector3d>{{-1, t, 0}, {1, t, 0}, {-1, -t, 0}, {1, -t, 0},
             {0, -1, t}, {0, 1, t}, {0, -1, -t}, {0, 1, -t}, {t, 0, -1}, {t, 0, 1}, {-t, 0, -1}, {-t, 0, 1}})
        draft.point(p.normalized());
    draft.triangles = {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
        {11, 10, 2}, {10, 7, 6}, {7, 1, 8}, {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8}, {3, 8, 9}, {4, 9, 5},
        {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto [place, is_new] =
                middles.try_emplace(std::minmax(a, b), static_cast<int>(draft.points.size()));
            if (is_new)
                draft.point((draft.points[a] + draft.points[b]).normalized());
            return place->second;
        };
        const auto coarse = std::exchange(draft.triangles, {});
        for (const Eigen::Vector3i& f : coarse) {
            const int a = middle(f[0], f[1]), b = middle(f[1], f[2]), c = middle(f[2], f[0]);
            draft.triangle(f[0], a, c);
            draft.triangle(f[1], b, a);
            draft.triangle(f[2], c, b);
            draft.triangle(a, b, c);
        }
    }
    return draft.mesh();
}

TriangleMesh bumpy_sphere(int levels) {
    TriangleMesh mesh = icosphere(levels);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const Eigen::RowVector3d p = mesh.points.row(v);
        mesh.points.row(v) *= 1 + 0.12 * std::sin(5 * p.x()) * std::sin(6 * p.y() + 1)
                            + 0.08 * std::sin(7 * p.z() + 2 * p.x());
    }
    return mesh;
}

TriangleMesh torus(int around, int across) {
    Draft draft;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double u = 2 * k_pi * i / around, w = 2 * k_pi * j / across, r = 1 + 0.38 * std::cos(w);
            draft.point({r * std::cos(u), r * std::sin(u), 0.38 * std::sin(w)});
        }
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const int p = i * across, q = (i + 1) % around * across, next = (j + 1) % across;
            draft.quad(p + j, q + j, q + next, p + next);
        }
    return draft.mesh();
}

TriangleMesh double_torus(int k) {
    const Eigen::Vector3i cells(5 * k, 3 * k, k);
    const auto is_solid = [&](const Eigen::Vector3i& c) {
        const bool inside = (c.array() >= 0).all() && (c.array() < cells.array()).all();
        const int column = c.x() / k;
        return inside && !(c.y() / k == 1 && (column == 1 || column == 3));
    };
    Draft draft;
    Lattice at{draft, Eigen::Vector3d::Constant(1.0 / k), {0, 0, 0}, {}};
    for (int i = 0; i < cells.x(); ++i)
        for (int j = 0; j < cells.y(); ++j)
            for (int l = 0; l < cells.z(); ++l) {
                const Eigen::Vector3i cell(i, j, l);
                for (int axis = 0; axis < 3 && is_solid(cell); ++axis)
                    for (const int sign : {-1, 1}) {
                        if (is_solid(cell + sign * Eigen::Vector3i::Unit(axis)))
                            continue;
                        const Eigen::Vector3i u = Eigen::Vector3i::Unit((axis + 1) % 3);
                        const Eigen::Vector3i w = Eigen::Vector3i::Unit((axis + 2) % 3);
                        const Eigen::Vector3i p = cell + (sign > 0 ? 1 : 0) * Eigen::Vector3i::Unit(axis);
                        const auto id = [&](const Eigen::Vector3i& c) { return at(c.x(), c.y(), c.z()); };
                        const int a = id(p), b = id(p + u), c = id(p + u + w), d = id(p + w);
                        sign > 0 ? draft.quad(a, b, c, d) : draft.quad(a, d, c, b);
                    }
            }
    return draft.mesh();
}

TriangleMesh sheet(int nx, int ny) {
    Draft draft;
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i)
            draft.point({static_cast<double>(i) / nx, static_cast<double>(j) / nx, 0});
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            const int p = j * (nx + 1) + i;
            draft.quad(p, p + 1, p + nx + 2, p + nx + 1);
        }
    return draft.mesh();
}

TriangleMesh bumpy_sheet(int nx, int ny) {
    TriangleMesh mesh = sheet(nx, ny);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const double x = mesh.points(v, 0), y = mesh.points(v, 1);
        mesh.points(v, 2) = 0.11 * std::sin(7 * x + 1) * std::cos(5 * y) + 0.07 * std::sin(9 * y + 3 * x * x);
    }
    return mesh;
}

TriangleMesh flat_ring(int rows, int around) {
    Draft draft;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < around; ++j) {
            const double r = 1 + static_cast<double>(i) / (rows - 1), u = 2 * k_pi * j / around;
            draft.point({r * std::cos(u), r * std::sin(u), 0});
        }
    for (int i = 0; i + 1 < rows; ++i)
        for (int j = 0; j < around; ++j) {
            const int p = i * around, q = p + around, next = (j + 1) % around;
            draft.quad(p + j, q + j, q + next, p + next);
        }
    return draft.mesh();
}

TriangleMesh cylinder(int around, int along, double height) {
    Draft draft;
    for (int j = 0; j <= along; ++j)
        for (int i = 0; i < around; ++i) {
            const double u = 2 * k_pi * i / around;
            draft.point({std::cos(u), std::sin(u), height * j / along});
        }
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < around; ++i) {
            const int p = j * around, next = (i + 1) % around;
            draft.quad(p + i, p + next, p + around + next, p + around + i);
        }
    return draft.mesh();
}

TriangleMesh moebius(int around, int across) {
    Draft draft;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j <= across; ++j) {
            const double t = 2 * k_pi * i / around, s = 0.35 * (2.0 * j / across - 1);
            const double r = 1 + s * std::cos(t / 2);
            draft.point({r * std::cos(t), r * std::sin(t), s * std::sin(t / 2)});
        }
    const auto at = [&](int i, int j) { return i < around ? i * (across + 1) + j : across - j; };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j)
            draft.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    return draft.mesh();
}

TriangleMesh klein_bottle(int around, int across) {
    Draft draft;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double u = 2 * k_pi * i / around, w = 2 * k_pi * j / across;
            const double r = 2 + std::cos(u / 2) * std::sin(w) - std::sin(u / 2) * std::sin(2 * w);
            draft.point({r * std::cos(u), r * std::sin(u),
                         std::sin(u / 2) * std::sin(w) + std::cos(u / 2) * std::sin(2 * w)});
        }
    const auto at = [&](int i, int j) {
        return i < around ? i * across + j % across : (2 * across - j) % across;
    };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j)
            draft.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    return draft.mesh();
}

TriangleMesh two_spheres(int levels) {
    return joined({icosphere(levels), moved(icosphere(levels), Eigen::Affine3d(Eigen::Translation3d(4, 0, 0)))});
}

TriangleMesh three_sheets(int n) {
    Draft draft;
    for (int j = 0; j <= n; ++j)
        draft.point({0, 0, static_cast<double>(j) / n});
    for (int s = 0; s < 3; ++s) {
        const int base = static_cast<int>(draft.points.size());
        for (int i = 1; i <= n; ++i)
            for (int j = 0; j <= n; ++j) {
                const double angle = 2 * k_pi * s / 3, r = static_cast<double>(i) / n;
                draft.point({r * std::cos(angle), r * std::sin(angle), static_cast<double>(j) / n});
            }
        const auto at = [&](int i, int j) { return i == 0 ? j : base + (i - 1) * (n + 1) + j; };
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                draft.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
    return draft.mesh();
}

TriangleMesh bow_tie(int n) {
    const TriangleMesh one = sheet(n, n);
    TriangleMesh both = joined({one, moved(one, Eigen::Affine3d(Eigen::Translation3d(1, 1, 0)))});
    const int last = one.vertex_count() - 1, first_of_second = one.vertex_count();
    const auto merged = [&](int v) { return v == first_of_second ? last : v > first_of_second ? v - 1 : v; };
    both.triangles = both.triangles.unaryExpr(merged).eval();
    Points points(both.vertex_count() - 1, 3);
    points << both.points.topRows(first_of_second), both.points.bottomRows(one.vertex_count() - 1);
    both.points = points;
    return both;
}

} // namespace shapes
