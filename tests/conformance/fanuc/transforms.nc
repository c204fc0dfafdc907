(G51.1, G51 and G68 together: which goes through which, and what their centres and angles are.)
(SOURCE FANUC 30i operator's manual B-63944EN, scaling, mirror image and coordinate rotation; expected places are closed forms)

(CASE G51 without a centre under a mirror leaves the tool where its block's numbers are)
%
O1
G90 G0 X0 Y0
G51.1 X0
X10.
#100=#5021
G51 P2000
#101=#5001
X10.
#102=#5021
X20.
#103=#5021
X0
#104=#5021
G50
#105=#5001
M30
%
(EXPECT #100 = -10)
(EXPECT #101 = 10)
(EXPECT #102 = -10)
(EXPECT #103 = -30)
(EXPECT #104 = 10)
(EXPECT #105 = -10)

(CASE the mirror takes the centre of G51 along)
%
O1
G90 G0 X0 Y0
G51.1 X4. Y1.
G51 X10. Y5. P2000
X10. Y5.
#100=#5021
#101=#5022
X12. Y6.
#102=#5021
#103=#5022
M30
%
(EXPECT #100 = -2)
(EXPECT #101 = -3)
(EXPECT #102 = -6)
(EXPECT #103 = -5)

(CASE of the axes that G51 does not name the centre is where the tool is)
%
O1
G90 G0 X0 Y0
G51.1 X0 Y0
X10. Y4.
G51 X3. P3000
X3. Y4.
#100=#5021
#101=#5022
X4. Y6.
#102=#5021
#103=#5022
M30
%
(EXPECT #100 = -3)
(EXPECT #101 = -4)
(EXPECT #102 = -6)
(EXPECT #103 = -10)

(CASE mirror, scaling and rotation about one point: it stays, and the plane turns the other way)
%
O1
G90 G0 X0 Y0
G51.1 X0
G51 X10. Y0 P2000
G68 X10. Y0 R90.
X10. Y0
#100=#5021
#101=#5022
X20.
#102=#5021
#103=#5022
M30
%
(EXPECT #100 = -10)
(EXPECT #101 = 0 WITHIN 0.000000001)
(EXPECT #102 = -10 WITHIN 0.000000001)
(EXPECT #103 = 20)

(CASE G51 in G51 without a centre: it is where the tool is, not the number that led there)
%
O1
G90 G0 X0 Y0
G51 X0 Y0 P2000
X10.
#100=#5021
G51 P3000
#101=#5001
X20.
#102=#5021
X10.
#103=#5021
M30
%
(EXPECT #100 = 20)
(EXPECT #101 = 20)
(EXPECT #102 = 20)
(EXPECT #103 = -10)

(CASE G51 without a centre while G68 turns the plane)
%
O1
G90 G0 X0 Y0
G68 X0 Y0 R90.
X10. Y0
G51 P2000
X10. Y0
#100=#5021
#101=#5022
X15.
#102=#5022
M30
%
(EXPECT #100 = 0 WITHIN 0.000000001)
(EXPECT #101 = 10)
(EXPECT #102 = 20)

(CASE G101 of a Haas takes the centre of G51 along, too)
(CONTROL haas)
%
O1
G90 G0 X0 Y0
G101 X0
X10.
G51 P2.
X10.
#100=#5021
G50
G51 X10. Y0 P2.
X20. Y0
#101=#5021
M30
%
(EXPECT #100 = -10)
(EXPECT #101 = -30)

(CASE and so does G51.1 of MELDAS)
(CONTROL meldas)
%
O1
G90 G0 X0 Y0
G51.1 X0
X10.
G51 P2.
X10.
#100=#5021
X20.
#101=#5021
M30
%
(EXPECT #100 = -10)
(EXPECT #101 = -30)

(CASE R of G68 adds to the last one under G91, and counts for a G68 without R)
(CONTROL meldas)
(SOURCE M700V programming manual 13.21 (1) and (5), page 448)
%
O1
G90 G0 X0 Y0
G68 X0 Y0
X10. Y0
#100=#5021
G68 X0 Y0 R30.
G91 G68 X0 Y0 R30.
G90 X10. Y0
#101=#5021
#102=#5022
G68 X0 Y0
X10. Y0
#103=#5021
G91 G68 X0 Y0
G90 X10. Y0
#104=#5022
G68 X0 Y0 R30.
X10. Y0
#105=#5022
M30
%
(EXPECT #100 = 10)
(EXPECT #101 = 5)
(EXPECT #102 = 8.660254037844 WITHIN 0.000000000001)
(EXPECT #103 = 5)
(EXPECT #104 = 8.660254037844 WITHIN 0.000000000001)
(EXPECT #105 = 5)

(CASE it counts behind G69, too, and a mirror turns what it comes to)
(CONTROL meldas)
%
O1
G90 G0 X0 Y0
G68 X0 Y0 R20.
G69
G68 X0 Y0
G91 G68 X0 Y0 R10.
G69
G90 X0 Y0
G51.1 X0
G68 X0 Y0
X10. Y0
#100=#5021
#101=#5022
M30
%
(EXPECT #100 = -8.660254037844 WITHIN 0.000000000001)
(EXPECT #101 = 5)

(CASE elsewhere R is absolute, and a G68 without it turns by parameter 5410)
(PARAMETER 5410 = 90)
%
O1
G90 G0 X0 Y0
G68 X0 Y0 R30.
G91 G68 X0 Y0 R30.
G90 X10. Y0
#100=#5022
G68 X0 Y0
X10. Y0
#101=#5022
M30
%
(EXPECT #100 = 5)
(EXPECT #101 = 10)

(CASE by parameter 5400.0 it adds under G91 to the one in force)
(PARAMETER 5400.0 = 1)
%
O1
G90 G0 X0 Y0
G91 G68 X0 Y0 R10.
G68 X0 Y0 R20.
G90 X10. Y0
#100=#5022
G69
G91 G68 X0 Y0 R30.
G90 X10. Y0
#101=#5022
M30
%
(EXPECT #100 = 5)
(EXPECT #101 = 5)

(CASE settings 71 to 73 of a Haas: factor without P, angle without R, R that adds under G91)
(CONTROL haas)
(SOURCE Haas mill operator's manual, G51, G68 and settings 71 to 73)
(SET #20071 = 2)
(SET #20072 = 30)
(SET #20073 = 1)
%
O1
G90 G0 X0 Y0
G68 X0 Y0
X10. Y0
#100=#5021
G69
G51 X0 Y0
X10. Y0
#101=#5021
G51 X0 Y0 P3.
X10. Y0
#102=#5021
G50
G68 X0 Y0 R30.
G91 G68 X0 Y0 R30.
G90 X10. Y0
#103=#5021
#104=#20072
M30
%
(EXPECT #100 = 8.660254037844 WITHIN 0.000000000001)
(EXPECT #101 = 20)
(EXPECT #102 = 30)
(EXPECT #103 = 5)
(EXPECT #104 = 30)

(CASE settings that are 0 leave factor 1, angle 0 and an absolute R)
(CONTROL haas)
(SET #20071 = 0)
(SET #20072 = 0)
(SET #20073 = 0)
%
O1
G90 G0 X0 Y0
G51 X0 Y0
G68 X0 Y0
X10. Y0
#100=#5021
G68 X0 Y0 R30.
G91 G68 X0 Y0 R30.
G90 X10. Y0
#101=#5022
M30
%
(EXPECT #100 = 10)
(EXPECT #101 = 5)

(CASE 11600.5 = 0: an axis that is not named is where the program had it before the rotation)
(CONTROL fanuc-30i)
(SOURCE FANUC 30i parameter manual, parameter 11600.5, its example; from general knowledge, unverified)
%
O1
G90 G0 X0 Y0
G1 X10. Y10. F1000
G68 X0 Y0 R45.
#101=#5001
#102=#5002
Y14.142
#103=#5021
#104=#5022
#105=#5001
X5.
#106=#5021
#107=#5002
M30
%
(EXPECT #101 = 14.142135623731 WITHIN 0.000000000001)
(EXPECT #102 = 0 WITHIN 0.000000000001)
(EXPECT #103 = -2.928836287675 WITHIN 0.000000000001)
(EXPECT #104 = 17.070971911406 WITHIN 0.000000000001)
(EXPECT #105 = 10)
(EXPECT #106 = -6.464370193607 WITHIN 0.000000000001)
(EXPECT #107 = 14.142)

(CASE 11600.5 = 1: it is where the tool is in the turned plane)
(CONTROL fanuc-30i)
(PARAMETER 11600.5 = 1)
%
O1
G90 G0 X0 Y0
G1 X10. Y10. F1000
G68 X0 Y0 R45.
Y14.142
#103=#5021
#104=#5022
M30
%
(EXPECT #103 = 0.00009590046 WITHIN 0.000000000001)
(EXPECT #104 = 19.99990409954 WITHIN 0.000000000001)

(CASE and so it is on a 16i, without a parameter)
(CONTROL fanuc-16i)
%
O1
G90 G0 X0 Y0
G1 X10. Y10. F1000
G68 X0 Y0 R45.
Y14.142
#103=#5021
#104=#5022
M30
%
(EXPECT #103 = 0.00009590046 WITHIN 0.000000000001)
(EXPECT #104 = 19.99990409954 WITHIN 0.000000000001)

(CASE 11600.5 = 0: blocks that name no axis of the plane leave both, and the next one still counts)
(CONTROL fanuc-30i)
%
O1
G90 G0 X10. Y10.
G68 X0 Y0 R90.
Z5.
#100=#5021
#101=#5022
Y3.
#102=#5021
#103=#5022
M30
%
(EXPECT #100 = 10)
(EXPECT #101 = 10)
(EXPECT #102 = -3)
(EXPECT #103 = 10)

(CASE 11600.5 = 0: distances under G91 go from where the tool is and count on for the other axis)
(CONTROL fanuc-30i)
%
O1
G90 G0 X10. Y10.
G68 X0 Y0 R90.
G91 X5.
#100=#5021
#101=#5022
G90 Y20.
#102=#5021
#103=#5022
M30
%
(EXPECT #100 = 10)
(EXPECT #101 = 15)
(EXPECT #102 = -20)
(EXPECT #103 = 15)

(CASE 11600.5 = 0: another G68 in rotation, too; both axes named need nothing; G69 ends it)
(CONTROL fanuc-30i)
%
O1
G90 G0 X0 Y0
G68 X0 Y0 R90.
X10. Y0
#100=#5021
#101=#5022
G68 X0 Y0 R180.
Y2.
#102=#5021
#103=#5022
G68 X0 Y0 R90.
G69
Y5.
#104=#5021
#105=#5022
M30
%
(EXPECT #100 = 0 WITHIN 0.000000000001)
(EXPECT #101 = 10)
(EXPECT #102 = -10)
(EXPECT #103 = -2)
(EXPECT #104 = -10)
(EXPECT #105 = 5)

(CASE 11600.5 = 0: arcs and canned cycles)
(CONTROL fanuc-30i)
%
O1
G90 G0 X10. Y0
G68 X0 Y0 R90.
G2 Y10. R15. F1000
#100=#5021
#101=#5022
G69
G0 X10. Y10.
G68 X0 Y0 R90.
G81 Y3. Z-5. R2. F100
G80
#102=#5021
#103=#5022
M30
%
(EXPECT #100 = -10)
(EXPECT #101 = 10)
(EXPECT #102 = -3)
(EXPECT #103 = 10)

(CASE 11600.5 = 0: G31 goes there, and where its signal stopped it the tool's place counts)
(CONTROL fanuc-30i)
(SIGNAL X0)
(SIGNAL X0)
%
O1
G90 G0 X10. Y10.
G68 X0 Y0 R90.
G31 Y20. F1000
#100=#5021
#101=#5022
G69
G0 X10. Y10.
G68 X0 Y0 R90.
G91 G31 Y20. F1000
G90 G0 X5.
#102=#5021
#103=#5022
M30
%
(EXPECT #100 = 0)
(EXPECT #101 = 10)
(EXPECT #102 = 0 WITHIN 0.000000000001)
(EXPECT #103 = 5)

(CASE 11600.5 = 0: under a mirror the axis that is not named is mirrored as a named one)
(CONTROL fanuc-30i)
%
O1
G90 G0 X0 Y0
G51.1 X0
X10. Y10.
G68 X0 Y0 R90.
Y3.
#100=#5021
#101=#5022
M30
%
(EXPECT #100 = 3)
(EXPECT #101 = 10)

(CASE in inches, too)
(CONTROL fanuc-30i)
%
O1
G20 G90 G0 X1. Y1.
G68 X0 Y0 R90.
Y.3
#100=#5021
#101=#5022
M30
%
(EXPECT #100 = -0.3 WITHIN 0.000000000001)
(EXPECT #101 = 1)
