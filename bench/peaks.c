/* What one core can do at most: vectors of eight doubles, one instruction at a time or in turn.
 *
 *     cc -O1 -mavx512f bench/peaks.c -o out/peaks && out/peaks
 *
 * Prints cycles an instruction, or a group of them: a dependent product of integers takes three. (An
 * addition of a constant some processors do without a cycle of its own.) For a processor with AVX-512. */
#include <stdio.h>
#include <time.h>

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

static double cycle = 1;

#define TWICE(x) x x
#define REPEAT(x) TWICE(TWICE(TWICE(TWICE(x)))) /* 16 times */
#define REGISTERS "rax", "k1", "zmm0", "zmm1", "zmm2", "zmm3", "zmm4", "zmm5", "zmm6", "zmm7"
#define MEASURE(body) ({                                              \
    double best = 1e9;                                                \
    for (int round = 0; round < 30; round++) {                        \
        double start = now();                                         \
        for (int i = 0; i < 20000; i++)                               \
            __asm__ volatile(REPEAT(body) ::: REGISTERS);             \
        double passed = now() - start;                                \
        if (passed < best) best = passed;                             \
    }                                                                 \
    best / 20000 / 16; })
#define SHOW(name, count, body) printf("%-40s %6.2f\n", name, MEASURE(body) / (count) / cycle)

/* four independent results of an operation; of two in turn */
#define FOUR(op) op " %%zmm7,%%zmm7,%%zmm0\n" op " %%zmm7,%%zmm7,%%zmm1\n" \
                 op " %%zmm7,%%zmm7,%%zmm2\n" op " %%zmm7,%%zmm7,%%zmm3\n"

int main(void) {
    cycle = MEASURE("imul %%rax,%%rax\n") / 3;
    printf("%-40s %6.3f ns\n", "a cycle", 1e9 * cycle);
    SHOW("addition", 4, FOUR("vaddpd"));
    SHOW("multiplication", 4, FOUR("vmulpd"));
    SHOW("fused multiply-add", 4, FOUR("vfmadd213pd"));
    SHOW("selection by bits", 4, FOUR("vpandq"));
    SHOW("four additions and four products", 1, FOUR("vaddpd") FOUR("vmulpd"));
    SHOW("the same and four selections", 1, FOUR("vaddpd") FOUR("vmulpd") FOUR("vpandq"));
    SHOW("addition, product, constant from memory", 1,
         "vbroadcastsd -64(%%rsp),%%zmm4\nvaddpd %%zmm7,%%zmm7,%%zmm0\nvmulpd %%zmm7,%%zmm7,%%zmm1\n");
    SHOW("division", 4, FOUR("vdivpd"));
    SHOW("division and sixteen products", 1,
         "vdivpd %%zmm7,%%zmm7,%%zmm4\n" TWICE(TWICE(FOUR("vmulpd"))));
    SHOW("square root", 1, "vsqrtpd %%zmm7,%%zmm0\n");
    SHOW("from an addition to the next", 1, "vaddpd %%zmm0,%%zmm0,%%zmm0\n");
    SHOW("from a product to the next", 1, "vmulpd %%zmm0,%%zmm0,%%zmm0\n");
    SHOW("from a division to the next", 1, "vdivpd %%zmm7,%%zmm0,%%zmm0\n");
    SHOW("from a square root to the next", 1, "vsqrtpd %%zmm0,%%zmm0\n");
    return 0;
}
