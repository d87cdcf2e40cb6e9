#pragma once
// The two small DNAs of the thesis, as printed.

inline constexpr auto uniqueFour = R"(# Start vector
START: a0
# Internal node at level 1
g1(a1|a0)
g2(divide|a0)
# Internal nodes at level 2
g3(a2|a1,A)
g4(a3|a1,B)
g5(divide|a1)
# Transition to final state
g6(a4|a2,A)
g7(a5|a2,B)
g8(a6|a3,A)
g9(a7|a3,B)
# Final nodes
g10(a4|a4)
g11(a5|a5)
g12(a6|a6)
g13(a7|a7)
)";

inline constexpr auto equalSubtrees = R"(# Start vector
START: a0
# Internal node at level 1
g1(a1|a0)
g2(divide|a0)
# Internal nodes at level 2
g3(a2|a1,A)
g4(a3|a1,B)
g5(divide|a1)
# Transition to final state
g6(a4|a2,A)
g7(a5|a2,B)
g8(a6|a3,B)
g9(a2|a3,A)
g10(divide|a3,A)
# Final state
g11(a4|a4)
g12(a5|a5)
g13(a6|a6)
)";
