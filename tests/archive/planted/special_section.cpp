// Fault: constants in a section that a user's linker script does not know.
__attribute__((section(".at_my_place"))) extern const double netmesh_table[2] = {1.0, 2.0};

extern "C" double netmesh_special_section(unsigned i) { return netmesh_table[i & 1]; }
