#pragma once

namespace honka {

/// Cells of sides (σ_r, σ_t) in the paper's search space, rotations × 10 × 10 × 2 m³, with
/// rotations in a ball of diameter 180°. Nevalainen2021 Table 3 prints 350e6 for 1.0° and 1.2 m.
[[nodiscard]] double search_size_of_ball(double rotation_deg, double translation_m);

/// The same with rotations in a box: two turns of 180°, and one of `zone_deg`. Table 3 prints 1.5e6
/// for 3.7°, 60° and 1.9 m, which is the size at 1.75 m.
[[nodiscard]] double search_size_of_box(double rotation_deg, double translation_m, double zone_deg);

}  // namespace honka
