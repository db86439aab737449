// Fault: three mebibytes of constants.
extern "C" const unsigned char netmesh_large[3 << 20] = {1};
