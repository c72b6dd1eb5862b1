#pragma once

#include "lissom/isoline/proxy.h"
#include "lissom/solve/sparse_cholesky.h"
#include "lissom/mesh/working_mesh.h"

#include <memory>
#include <optional>

namespace lissom {

enum class Smoothing {
    automatic, ///< where the first three pairs of steps take a third of the bending energy away: noise, needles, turned-over triangles
    never,
    always
};

struct IsolineModelOptions {
    int proxy_vertices = 50000;   ///< a model of more than 1.2 times as many is worked on through a proxy of about these
    Smoothing smoothing = Smoothing::automatic;
    int smoothing_steps = 20;     ///< pairs, see taubin_step
};

/// What the isoline method prepares once per mesh: the surface that fields and energies are computed on. Of a
/// small clean mesh that is the mesh itself, of a large one a proxy that its vertices are bound to, of a noisy one a smoothed
/// copy; only the final positions are made of the vertices as they are.
///
/// Cost: linear. Memory: see estimate_bytes.
class IsolineModel {
public:
    /// Call step() until it returns false. @param working  kept by reference: must outlive the model
    explicit IsolineModel(const WorkingMesh& working, IsolineModelOptions options = {});
    ~IsolineModel();
    IsolineModel(IsolineModel&&) noexcept;

    /// One slice. @returns true while there is more
    bool step();
    [[nodiscard]] double fraction() const;

    // What follows requires that step() has returned false.
    [[nodiscard]] const WorkingMesh& working() const;
    [[nodiscard]] const Proxy& surface() const;               ///< fields and energies are computed on it; D of the working mesh is 1
    [[nodiscard]] const SparseMatrix& laplacian() const;      ///< of the surface
    [[nodiscard]] const Eigen::VectorXd& areas() const;       ///< of the surface, a third of the ring
    [[nodiscard]] const VertexRings& rings() const;           ///< of the surface
    [[nodiscard]] bool is_proxy() const;
    [[nodiscard]] bool smoothed() const;
    [[nodiscard]] const SurfaceBinding& binding() const;      ///< of the working vertices; empty unless is_proxy()

    /// One number a surface vertex → a working vertex; row by row. Vertices bound to nothing get 0.
    /// @param fields  surface vertices × k
    [[nodiscard]] Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> to_working(const Columns& fields) const;

    [[nodiscard]] double memory_bytes() const;
    [[nodiscard]] double seconds() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Most bytes that preparing a model and then a session of it takes at one time, beside the working mesh itself: to say before it starts.
/// @param handles  those of the user and the rest that is held
struct IsolineMemory {
    double model = 0;   ///< peak while the model is prepared
    double session = 0; ///< peak while a session is prepared, the model included
    double settle = 0;  ///< further bytes of the full pass, 0 where there is none
};
[[nodiscard]] IsolineMemory estimate_isoline_memory(double vertices, double triangles, int handles, int controls = 10, int proxy_vertices = 50000,
                                                    double settle_limit = 200000);

} // namespace lissom
