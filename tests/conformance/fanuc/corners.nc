(,C and ,R: chamfers and roundings between two blocks.  Centres and ends by closed form.)
(SOURCE FANUC B-63844EN, optional angle chamfering and corner rounding; from general knowledge, unverified)

(CASE ,R rounds the corner behind its block, ,C cuts it off as far before as behind)
%
O1
G1 X20. F100. ,R5.
Y20. ,C3.
X40.
M30
%
(EXPECT MOVE 1 G1 X15 Y0)
(EXPECT MOVE 2 G3 X20 Y5)
(EXPECT MOVE 3 G1 X20 Y17)
(EXPECT MOVE 4 G1 X23 Y20)
(EXPECT MOVE 5 G1 X40 Y20)
(EXPECT MOVES 5)

(CASE a chamfer where the way turns by less than a right angle: 3, 4 and 5 mm)
%
O1
G1 X20. F100. ,C5.
X26. Y8.
M30
%
(EXPECT MOVE 1 G1 X15 Y0)
(EXPECT MOVE 2 G1 X23 Y4)

(CASE the centre of a rounding in an arc is the radius of the arc less its own from the arc's)
%
O1
G1 X20. F100. ,R1.8
G3 X10. Y10. I-10. J0
M30
%
(EXPECT MOVE 1 G1 X18 Y0)
(EXPECT MOVE 2 G3 X19.7560976 Y2.1951220)
(EXPECT MOVE 3 G3 X10 Y10)

(CASE between two arcs, outside of both: 15, 8 and 17 mm)
%
O1
G0 X24. Y-8.
G3 X20. Y0. I-10. J0. F100. ,R7.
X24. Y8. I-6. J8.
M30
%
(EXPECT MOVE 2 G3 X22.8235294 Y-3.2941176)
(EXPECT MOVE 3 G2 X22.8235294 Y3.2941176)
(EXPECT MOVE 4 G3 X24 Y8)

(CASE a chamfer ends as far from the corner on an arc, too)
%
O1
G1 X20. F100. ,C12.
G3 X10. Y10. I-10. J0
M30
%
(EXPECT MOVE 1 G1 X8 Y0)
(EXPECT MOVE 2 G1 X12.8 Y9.6)
(EXPECT MOVE 3 G3 X10 Y10)

(CASE sizes are words like others: variables, least increments, none at 0)
%
O1
#1=4.
G1 X20. F100. ,R#1
Y20. ,C[#1/2.]
X40. ,C500
Y40. ,R0
X60.
M30
%
(EXPECT MOVE 1 G1 X16 Y0)
(EXPECT MOVE 3 G1 X20 Y18)
(EXPECT MOVE 4 G1 X22 Y20)
(EXPECT MOVE 5 G1 X39.5 Y20)
(EXPECT MOVE 6 G1 X40 Y20.5)
(EXPECT MOVE 7 G1 X40 Y40)
(EXPECT MOVES 8)

(CASE inches)
%
O1
G20 G1 X2. F10. ,C.5
Y2.
M30
%
(EXPECT MOVE 1 G1 X38.1 Y0)
(EXPECT MOVE 2 G1 X50.8 Y12.7)

(CASE of the plane of G18)
%
O1
G18 G1 X20. F100. ,R5.
Z20.
M30
%
(EXPECT MOVE 1 G1 X15 Z0)
(EXPECT MOVE 2 G2 X20 Z5)

(CASE the programmed end is that of the corner, and work variables see it)
%
O1
G1 X20. F100. ,R5.
#100=#5001
#101=#5041
Y20.
M30
%
(EXPECT #100 = 20)
(EXPECT #101 = 20)
(EXPECT MOVE 2 G3 X20 Y5)

(CASE a corner that just fits)
%
O1
G1 X10. F100. ,R5.
Y5. ,C0
X20. ,C10.
Y15.
M30
%
(EXPECT MOVE 1 G1 X5 Y0)
(EXPECT MOVE 2 G3 X10 Y5)
(EXPECT MOVE 3 G1 X20 Y15)
(EXPECT MOVES 3)

(CASE within 1 degree there is no corner)
%
O1
G1 X20. F100. ,R5.
X40. Y.34
G0 X0. Y0.
G1 X20. ,R5.
X40. Y.36
M30
%
(EXPECT MOVE 1 G1 X20 Y0)
(EXPECT MOVE 2 G1 X40 Y0.34)
(EXPECT MOVES 6)

(CASE cutter compensation goes along the rounded path)
%
O1
#13001=5.
G0 X-30.
G41 D1 G1 X-20. F100.
X0. ,R8.
Y20.
G40 X20.
M30
%
(EXPECT MOVE 2 G1 X-20 Y5)
(EXPECT MOVE 3 G1 X-8 Y5)
(EXPECT MOVE 4 G3 X-5 Y8)
(EXPECT MOVE 5 G1 X-5 Y20)

(SOURCE Haas mill operator's manual 96-8000, G01: corner rounding and chamfering)

(CASE a dwell may stand between)
(CONTROL haas)
%
O1
G1 X20. F100. ,C5.
G4 P500
Y20.
M30
%
(EXPECT MOVE 1 G1 X15 Y0)
(EXPECT MOVE 2 G1 X20 Y5)
(EXPECT MOVE 3 G4 T0.5)
(EXPECT MOVE 4 G1 X20 Y20)

(SOURCE FANUC alarm list, PS0051 to PS0055)

(CASE the way in front of it is too short)
%
O1
G1 X4. F100. ,C5.
Y20.
M30
%
(EXPECT ALARM 55 AT 3)

(CASE the way behind it)
%
O1
G1 X20. F100. ,R5.
Y4.
M30
%
(EXPECT ALARM 55 AT 3)

(CASE an arc is too small for it)
%
O1
G1 X20. F100. ,R6.
G3 X10. Y10. I-10. J0
M30
%
(EXPECT ALARM 55 AT 3)

(CASE nothing but motion behind it)
%
O1
G1 X20. F100. ,R5.
M8
Y20.
M30
%
(EXPECT ALARM 52 AT 4)

(CASE no rapid)
%
O1
G1 X20. F100. ,R5.
G0 Y20.
M30
%
(EXPECT ALARM 52 AT 4)

(CASE no end of the program)
%
O1
G1 X20. F100. ,R5.
M30
%
(EXPECT ALARM 52 AT 4)

(CASE no other plane)
%
O1
G1 X20. F100. ,R5.
G18 Z20.
M30
%
(EXPECT ALARM 51 AT 4)

(CASE no other axis alone)
%
O1
G1 X20. F100. ,R5.
Z20.
M30
%
(EXPECT ALARM 51 AT 4)

(CASE nor along with the plane)
%
O1
G1 X20. F100. ,R5.
Y20. Z5.
M30
%
(EXPECT ALARM 51 AT 3)

(CASE not both)
%
O1
G1 X20. F100. ,R5. ,C3.
Y20.
M30
%
(EXPECT ALARM 53 AT 3)

(CASE no argument of a macro)
%
O1
G65 P2 ,C3.
M30
O2
M99
%
(EXPECT ALARM 129 AT 3)

(SOURCE MITSUBISHI MELDAS, corner chamfering and corner rounding: P382 to P385)

(CASE none in a rapid)
(CONTROL meldas)
%
O1
G0 X20. ,R5.
Y20.
M30
%
(EXPECT ALARM 385 AT 4)

(CASE the last one of a block counts)
(CONTROL meldas)
%
O1
G1 X20. F100. ,R5. ,C3.
Y20.
M30
%
(EXPECT MOVE 1 G1 X17 Y0)
(EXPECT MOVE 2 G1 X20 Y3)

(CASE numbers of their own for the way in front and the way behind)
(CONTROL meldas)
%
O1
G1 X20. F100. ,R5.
Y4.
M30
%
(EXPECT ALARM 384 AT 4)

(CASE the way in front)
(CONTROL meldas)
%
O1
G1 X4. F100. ,R5.
Y40.
M30
%
(EXPECT ALARM 383 AT 4)

(CASE no motion behind it)
(CONTROL meldas)
%
O1
G1 X20. F100. ,R5.
M30
%
(EXPECT ALARM 382 AT 5)

(CASE MB-297 with parameter 5004.2, ODI, what D names is a diameter)
(CONTROL fanuc-16i fanuc-30i)
(PARAMETER 5004.2 = 1)
(SHEET [tools.5])
(SHEET radius = 16.0)
%
O1
G90 G17
G41 G1 X20. Y20. D5 F500
Y60.
Y80.
G40 G0 X0
M30
%
(EXPECT MOVE 2 X12 Y60)
