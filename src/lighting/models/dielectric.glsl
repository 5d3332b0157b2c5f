// SPDX-License-Identifier: Apache-2.0
// The border of two transparent bodies. eta: index of refraction in front, where the direction v is, over that behind.
// Source: Born & Wolf 1999, "Principles of Optics", section 1.5: the law of refraction (eq. 8), Fresnel's equations (eq. 21).

// cos^2 of the refracted direction, below 0 where all light is reflected; cosine: n.v.
RL_FN real refracted_cosine_squared(real cosine, real eta)
{
    return 1.0f - eta * eta * (1.0f - cosine * cosine);
}

// [1] 0..1: the share of unpolarized light that is reflected; 1 under total reflection.
RL_FN real fresnel(real cosine, real eta)
{
    real c = clamp(cosine, 0.0f, 1.0f);
    real squared = refracted_cosine_squared(c, eta);
    real behind = safe_sqrt(squared);
    real across = (eta * c - behind) / max(eta * c + behind, 1e-20f);
    real along = (eta * behind - c) / max(eta * behind + c, 1e-20f);
    return select(squared > 0.0f, min(0.5f * (across * across + along * along), 1.0f), 1.0f);
}

// The direction in which light continues behind the border, away from it; unit for unit n and v. Under total reflection: along it.
RL_FN vec3 refracted(vec3 n, vec3 v, real eta)
{
    real c = dot(n, v);
    return n * (eta * c - safe_sqrt(refracted_cosine_squared(c, eta))) - v * eta;
}
