/* Half of a user's program, in C99 and in C++: eight points on a circle. */
extern const double* points_of_user(unsigned* count);

const double* points_of_user(unsigned* count) {
    static const double points[] = {1, 0, .7, .7, 0, 1, -.7, .7, -1, 0, -.7, -.7, 0, -1, .7, -.7};
    *count = sizeof points / sizeof points[0] / 2;
    return points;
}
