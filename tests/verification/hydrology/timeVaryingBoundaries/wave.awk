# Heads in a saturated column, at rest at t = 0, whose lower end follows
# level + A sin(w t) and whose upper end is closed, against lines 'z psi'. With
# D = Ks/Ss, lambda = (n - 1/2) pi/L and a = D lambda^2,
#     H - level = A sin(w t) - A sum over n of 4/((2n - 1) pi) sin(lambda z)
#         w [a cos(w t) + w sin(w t) - a exp(-a t)]/(a^2 + w^2)
# which tends to the imaginary part of
#     A exp(i w t) cosh(k (L - z))/cosh(k L),    k = sqrt(i w/D)
# Prints the largest errors over A against both
function exact(z, t,    n, l, a, sum)
{
    sum = sin(w*t)
    for (n = 1; n <= 200; ++n) {
        l = (n - 0.5)*pi/L
        a = D*l*l
        sum -= 4/((2*n - 1)*pi)*sin(l*z)*w*(a*cos(w*t) + w*sin(w*t) \
            - (a*t < 700 ? a*exp(-a*t) : 0))/(a*a + w*w)
    }
    return sum
}

# cosh(x + i y) = cosh x cos y + i sinh x sin y; here x = y
function periodic(z, t,    x, y, re, im, reL, imL, amplitude, phase)
{
    x = sqrt(w/(2*D))*(L - z)
    y = sqrt(w/(2*D))*L
    re = (exp(x) + exp(-x))/2*cos(x)
    im = (exp(x) - exp(-x))/2*sin(x)
    reL = (exp(y) + exp(-y))/2*cos(y)
    imL = (exp(y) - exp(-y))/2*sin(y)
    amplitude = sqrt((re*re + im*im)/(reL*reL + imL*imL))
    phase = atan2(im, re) - atan2(imL, reL)
    return amplitude*sin(w*t + phase)
}

BEGIN { pi = 3.14159265358979; D = 1e-2 }

{
    d = ($2 + $1 - level)/A - exact($1, t)
    if (d < 0) d = -d
    if (d > worst) worst = d
    p = ($2 + $1 - level)/A - periodic($1, t)
    if (p < 0) p = -p
    if (p > off) off = p
}

END { if (NR) printf "%.3e %.3e\n", worst, off }
