#------------------------------------------------------------------------------
# slideFoam | from rain to runout
# Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
#------------------------------------------------------------------------------
# Description
#     The pressure head of Srivastava and Yeh (1991): a column of exponential
#     soil above a water table (psi = 0 at z = 0) whose steady flux qA at the
#     top changes to qB at t = 0.
#
#     Reads lines 'z [anything ...]' and prints 'z psi [anything ...]'. With
#     lengths times alpha, times times alpha Ks/(thetaS - thetaR) and fluxes
#     over Ks the solution is
#         K = qB - (qB - 1) exp(-z) - 4 (qB - qA) exp((L - z)/2) exp(-t/4)
#             sum sin(l z) sin(l L) exp(-l^2 t)/(1 + L/2 + 2 l^2 L)
#     over the positive roots l of tan(l L) + 2 l = 0.
#
# Usage
#     awk -v t=<s> -f exact.awk
#------------------------------------------------------------------------------

BEGIN {
    alpha = 10
    Ks = 0.01/3600
    L = alpha*1
    qA = 0.1
    qB = 0.9
    time = alpha*Ks*t/0.34
    pi = atan2(0, -1)
    nRoots = 80

    # sin(x) + (2/L) x cos(x) has one root in ((k - 1/2) pi, k pi)
    for (k = 1; k <= nRoots; ++k) {
        low = (k - 0.5)*pi
        high = k*pi
        sign = sin(low) > 0 ? 1 : -1
        for (i = 0; i < 60; ++i) {
            x = 0.5*(low + high)
            if (sign*(sin(x) + 2/L*x*cos(x)) > 0) low = x
            else high = x
        }
        root[k] = x/L
    }
}

{
    z = alpha*$1
    K = qB - (qB - 1)*exp(-z)

    # At the start the series is the difference of the two steady states
    if (time == 0) K = qA - (qA - 1)*exp(-z)
    else {
        sum = 0
        for (k = 1; k <= nRoots; ++k) {
            l = root[k]
            if (l*l*time < 700)
                sum += sin(l*z)*sin(l*L)*exp(-l*l*time)/(1 + L/2 + 2*l*l*L)
        }
        K -= 4*(qB - qA)*exp((L - z)/2)*exp(-time/4)*sum
    }

    head = log(K)/alpha
    rest = $0
    sub(/^[^ ]+ */, "", rest)
    printf "%.17g %.17g %s\n", $1, head, rest
}

#------------------------------------------------------------------------------
