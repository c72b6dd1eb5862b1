#pragma once

#include "lissom/deform/deform_session.h"
#include "lissom/isoline/isoline_model.h"
#include "lissom/isoline/reduced_energy.h"

#include <array>
#include <span>
#include <vector>

namespace lissom {

/// The handles of a session where fields and energies see them.
struct FieldHandles {
    std::vector<int> of_working; ///< per working vertex: a handle whose field is 1 there, or −1; the held rest is the one after the user's
    std::vector<int> of_surface; ///< per surface vertex, discs of points included
    std::vector<HandleEnd> ends; ///< one per field
    int user = 0;                ///< handles of the user: the first fields
    bool rest = false;           ///< vertices outside the region are held: one more field
    std::vector<std::array<int, 4>> touching; ///< handles a, b and working vertices of them that share an edge, one pair for each two handles
};

/// @throws InvalidInput  see IsolineSession
[[nodiscard]] FieldHandles field_handles(const IsolineModel& model, std::span<const int> roi, std::span<const DeformHandle> handles);

} // namespace lissom
