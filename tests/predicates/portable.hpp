// The predicates as targets without 128-bit integers compile them.
#pragma once

int portable_orient(int dim, const double* const* points);
int portable_in_ball(int dim, const double* const* points);  // the last of dim + 2 points is the query

// As builds compile them where size counts.
int small_orient(int dim, const double* const* points);
int small_in_ball(int dim, const double* const* points);
