#include "report/references.hpp"

#include <algorithm>
#include <array>

namespace riffle::inline report {

namespace {

/// A short name as it stands in texts, and the publication.
struct Known {
    const char* text;
    const char* name;
    const char* citation;
};

constexpr std::array known = {
    Known{"thesis", "the thesis",
          "Gabreil, E. (2017). Application of Smoothed Particle Hydrodynamics Modelling to Turbulent Open "
          "Channel Flows Over Rough Beds. PhD thesis, University of Sheffield. Published as Gabreil, E., "
          "Tait, S. J., Shao, S., Nichols, A. (2018). SPHysics simulation of laboratory shallow free "
          "surface turbulent flows over a rough bed. J. Hydraul. Res. 56, 727-747."},
    Known{
        "paper", "the paper",
        "Kazemi, E., Tait, S., Shao, S., Nichols, A. (2016). Potential application of mesh-free SPH method "
        "in turbulent "
        "river flows. In Hydrodynamic and Mass Transport at Freshwater Aquatic Interfaces, Springer, 11-22."},
    Known{"Dolcetti", "Dolcetti et al. 2016",
          "Dolcetti, G., Horoshenkov, K. V., Krynkin, A., Tait, S. J. (2016). Frequency-wavenumber spectrum "
          "of the free surface of shallow turbulent flows over a rough boundary. Phys. Fluids 28, 105105."},
    Known{"Fukagata", "Fukagata, Iwamoto & Kasagi 2002",
          "Fukagata, K., Iwamoto, K., Kasagi, N. (2002). Contribution of Reynolds stress distribution to "
          "the skin friction in wall-bounded flows. Phys. Fluids 14, L73-L76."},
    Known{"Horoshenkov", "Horoshenkov et al. 2013",
          "Horoshenkov, K. V., Nichols, A., Tait, S. J., Maximov, G. A. (2013). The pattern of surface "
          "waves in a shallow free surface flow. J. Geophys. Res. Earth Surf. 118, 1864-1876."},
    Known{"Hunt et al", "Hunt et al. 1988",
          "Hunt, J. C. R., Wray, A. A., Moin, P. (1988). Eddies, streams, and convergence zones in "
          "turbulent flows. Center for Turbulence Research, CTR-S88, 193-208."},
    Known{"Lamb", "Lamb 1932", "Lamb, H. (1932). Hydrodynamics, 6th edition. Cambridge University Press."},
    Known{"Lu & Willmarth", "Lu & Willmarth 1973",
          "Lu, S. S., Willmarth, W. W. (1973). Measurements of the structure of the Reynolds stress in a "
          "turbulent boundary layer. J. Fluid Mech. 60, 481-511."},
    Known{"Nezu", "Nezu; Nezu & Rodi; Nezu & Nakagawa",
          "Nezu, I., Nakagawa, H. (1993). Turbulence in Open-Channel Flows. IAHR Monograph, Balkema. Nezu, "
          "I., Rodi, W. (1986). Open-channel flow measurements with a laser Doppler anemometer. J. "
          "Hydraul. Eng. 112, 335-355."},
    Known{"Nikora et al. 2001", "Nikora et al. 2001",
          "Nikora, V., Goring, D., McEwan, I., Griffiths, G. (2001). Spatially averaged open-channel flow "
          "over rough bed. J. Hydraul. Eng. 127, 123-133."},
    Known{"Nikora et al. 2019", "Nikora et al. 2019",
          "Nikora, V. I., Stoesser, T., Cameron, S. M., Stewart, M., Papadopoulos, K., Ouro, P., McSherry, "
          "R., Zampiron, A., Marusic, I., Falconer, R. A. (2019). Friction factor decomposition for "
          "rough-wall flows: theoretical background and application to open-channel flows. J. Fluid Mech. "
          "872, 626-664."},
    Known{"Ritter", "Ritter 1892",
          "Ritter, A. (1892). Die Fortpflanzung der Wasserwellen. Z. Ver. Deutsch. Ing. 36, 947-954."},
    Known{"Tamburrino", "Tamburrino & Gulliver",
          "Tamburrino, A., Gulliver, J. S. (1999). Large flow structures in a turbulent open channel flow. "
          "J. Hydraul. Res. 37, 363-380."},
    Known{"Yang & Lim", "Yang & Lim 1997",
          "Yang, S.-Q., Lim, S.-Y. (1997). Mechanism of energy transportation and turbulent flow in a 3D "
          "channel. J. Hydraul. Eng. 123, 684-692."},
    Known{"Zhou et al", "Zhou et al. 1999",
          "Zhou, J., Adrian, R. J., Balachandar, S., Kendall, T. M. (1999). Mechanisms for generating "
          "coherent packets of hairpin vortices in channel flow. J. Fluid Mech. 387, 353-396."}};

}  // namespace

std::vector<Reference> cited_references(const std::vector<Analysis>& analyses,
                                        const std::vector<std::string>& texts) {
    std::string all;
    const auto add = [&](const std::string& text) { all += text + '\n'; };
    for (const std::string& text : texts) add(text);
    for (const Analysis& analysis : analyses) {
        for (const Figure& figure : analysis.figures) {
            add(figure.source);
            add(figure.caption);
            for (const Curve& curve : figure.curves) add(curve.name);
        }
        for (const Finding& finding : analysis.findings) {
            add(finding.reference_name);
            add(finding.remark);
        }
    }
    std::vector<Reference> cited;
    for (const Known& each : known) {
        if (all.find(each.text) != std::string::npos) cited.push_back({each.name, each.citation});
    }
    return cited;
}

}  // namespace riffle::inline report
