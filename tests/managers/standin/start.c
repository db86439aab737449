/* Vectors for a program of newlib on qemu's mps2-an386, whose RAM begins at 0. */
extern void _start(void);
__attribute__((section(".vectors"), used)) const void* const vectors[] = {(void*)0x00400000, (const void*)_start};
