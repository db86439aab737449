#!/bin/sh
# stack_limit.sh WORK: stack_limit.c, with nothing of the engine but its jobs, on a Cortex-M33 in qemu.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$1"
cd "$1"
flags=$(sed -n 's/^m33 [^ ]* //p' "$root/platform/cortexm/cores.txt")
board=$(sed -n 's/^m33 \([^ ]*\) .*/\1/p' "$root/platform/cortexm/cores.txt")
for source in memory/stack_switch api/job; do
    # shellcheck disable=SC2086
    arm-none-eabi-g++ -std=c++17 -Os -mthumb $flags -fno-exceptions -fno-rtti -ffunction-sections -I "$root/engine" \
        -c "$root/engine/$source.cpp"
done
# shellcheck disable=SC2086
arm-none-eabi-gcc -std=c99 -Os -mthumb $flags -Wall -Wextra -I "$root/engine/include" -I "$root/platform/cortexm" \
    "$root/tests/embedding/stack_limit.c" stack_switch.o job.o -o stack_limit.elf -nostartfiles \
    -T "$root/platform/cortexm/example.ld" -Wl,--gc-sections
timeout 60 qemu-system-arm -M "$board" -display none -monitor none -serial none \
    -semihosting-config enable=on,target=native -kernel stack_limit.elf >out 2>&1 || { cat out; exit 1; }
cat out
[ "$(grep -c ': right$' out)" = 3 ]
