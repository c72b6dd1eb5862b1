#include "handles.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <numeric>

namespace handles {

std::vector<Named> models() {
    return {{"bar", shapes::box(4, 20, 4, {1, 5, 1})},
            {"bumpy sphere", shapes::bumpy_sphere(3)},
            {"torus", shapes::torus()},
            {"double torus", shapes::double_torus()},
            {"bumpy sheet", shapes::bumpy_sheet(20, 14)},
            {"two spheres", shapes::two_spheres(2)}};
}

std::vector<int> everything(const Points& points) {
    std::vector<int> all(static_cast<std::size_t>(points.rows()));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

std::vector<DeformHandle> two_ends(const Points& points, double share) {
    Eigen::RowVector3d low = Eigen::RowVector3d::Constant(1e300), high = -low;
    for (int v = 0; v < points.rows(); ++v)
        if (points.row(v).allFinite()) {
            low = low.cwiseMin(points.row(v));
            high = high.cwiseMax(points.row(v));
        }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const double reach = share * (high - low)[axis];
    std::vector<DeformHandle> ends(2);
    for (int v = 0; v < points.rows(); ++v) {
        if (points(v, axis) < low[axis] + reach) ends[0].vertices.push_back(v);
        if (points(v, axis) > high[axis] - reach) ends[1].vertices.push_back(v);
    }
    return ends;
}

Affine3d turn(double degrees, const Vector3d& axis, const Vector3d& through) {
    return Eigen::Translation3d(through) * Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()) * Eigen::Translation3d(-through);
}

Affine3d some_affine() {
    Affine3d map = turn(70, {1, 2, -1});
    map.linear() *= (Eigen::Matrix3d() << 1.3, 0.4, 0, 0, 0.7, -0.2, 0.1, 0, 1.1).finished();
    return map.pretranslate(Vector3d(0.4, -2, 1));
}

Affine3d some_similarity() {
    return Eigen::Translation3d(-1, 0.5, 3) * turn(110, {-1, 1, 3}) * Eigen::Scaling(1.7);
}

Points images(const Affine3d& map, const Points& points) {
    return (points * map.linear().transpose()).rowwise() + map.translation().transpose();
}

double gap(const Points& a, const Points& b) {
    return (a - b).rowwise().norm().maxCoeff();
}

void factor(DeformSession& session) {
    while (session.step()) {
    }
}

Held::Held(const TriangleMesh& mesh, const std::vector<DeformHandle>& handles) : working(shapes::working(mesh)) {
    std::vector<lissom::Finding> warnings;
    region = lissom::hold_region(working, lissom::assign_roles(working, everything(mesh.points), handles), static_cast<int>(handles.size()), warnings);
    laplacian = lissom::cotangent_laplacian(region.mesh);
    areas = lissom::vertex_areas(region.mesh);
}

lissom::Columns Held::parameters(const std::vector<Affine3d>& maps) const {
    lissom::Columns w = lissom::Columns::Zero(region.columns() - region.unknowns, 3);
    for (std::size_t h = 0; h < maps.size(); ++h) {
        w.block<3, 3>(4 * static_cast<Eigen::Index>(h), 0) = (maps[h].linear() - Eigen::Matrix3d::Identity()).transpose();
        w.row(4 * static_cast<Eigen::Index>(h) + 3) = maps[h].translation().transpose();
    }
    return w;
}

Points Held::solved(const lissom::SparseMatrix& A, const Points& b) {
    return Eigen::SimplicialLLT<lissom::SparseMatrix>(A).solve(Eigen::MatrixXd(b));
}

DeformResult deform(const TriangleMesh& mesh, const std::vector<DeformHandle>& handles, const std::vector<Affine3d>& targets,
                    const DeformOptions& options) {
    const lissom::WorkingMesh working = shapes::working(mesh);
    DeformSession session(working, everything(mesh.points), handles, options);
    factor(session);
    return session.deform(targets);
}

double edge_rms(const TriangleMesh& rest, const Points& moved) {
    double sum = 0;
    const auto all = lissom::edges(rest);
    for (const lissom::Edge& e : all) {
        const double ratio = (moved.row(e.a) - moved.row(e.b)).norm() / (rest.points.row(e.a) - rest.points.row(e.b)).norm();
        sum += (ratio - 1) * (ratio - 1);
    }
    return std::sqrt(sum / static_cast<double>(all.size()));
}

double volume_ratio(const TriangleMesh& rest, const Points& moved) {
    return lissom::signed_volume({moved, rest.triangles}) / lissom::signed_volume(rest);
}

TriangleMesh shared_model(const std::string& name) {
    // From the repository's root, the build directory or the sources.
    const char* given = std::getenv("LISSOM_SHARED");
    std::ifstream file;
    for (const std::string& root : {std::string(given ? given : "../shared"), std::string("../../../shared"), std::string("../../shared")})
        if (!file.is_open()) file.open(root + "/data/" + name, std::ios::binary);
    TriangleMesh mesh;
    if (!file.is_open()) return mesh;
    std::string line;
    int vertices = 0, faces = 0, beside = 0; // bytes of a vertex beside its position
    while (std::getline(file, line) && line != "end_header") {
        if (line.rfind("element vertex ", 0) == 0) vertices = std::stoi(line.substr(15));
        if (line.rfind("element face ", 0) == 0) faces = std::stoi(line.substr(13));
        if (line.rfind("property uchar ", 0) == 0 && faces == 0) ++beside;
        if (line.rfind("property float n", 0) == 0) beside += 4; // normals
    }
    mesh.points.resize(vertices, 3);
    mesh.triangles.resize(faces, 3);
    for (int v = 0; v < vertices; ++v) {
        float p[3];
        file.read(reinterpret_cast<char*>(p), sizeof p);
        file.ignore(beside);
        mesh.points.row(v) << p[0], p[1], p[2];
    }
    for (int f = 0; f < faces; ++f) {
        std::int32_t corners[3];
        file.get(); // always 3
        file.read(reinterpret_cast<char*>(corners), sizeof corners);
        mesh.triangles.row(f) << corners[0], corners[1], corners[2];
    }
    return mesh;
}

} // namespace handles
