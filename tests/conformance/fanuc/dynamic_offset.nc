(G254 of a Haas, on a machine whose table turns about C and tilts about B.)
(SOURCE Haas mill operator's manual NGC, G254: the B value of the work offset must be 0)
(CONTROL haas)
(SHEET [machine])
(SHEET table_side = "CB")
(SHEET tool_side = "XYZ")
(SHEET [machine.axes.B])
(SHEET travel = [-120.0, 120.0])
(SHEET centre = [10.0, 0.0, -450.0])
(SHEET [machine.axes.C])
(SHEET travel = [-36000.0, 36000.0])
(SHEET [work_offsets.G54])
(SHEET X = 40.0)
(SHEET Y = -25.0)
(SHEET Z = -380.0)
(SHEET [tools.1])
(SHEET length = 120.0)

(CASE a work offset whose B is 0)
%
O1
G90 G0 C90.
G254
G0 X0 Y0
#101=#5021
#102=#5022
M30
%
(EXPECT #101 = -25 WITHIN 0.0000006)
(EXPECT #102 = -40 WITHIN 0.0000006)

(CASE alarm: a work offset whose B is not 0)
%
O1
#100=0
G10 L2 P1 B0.5
G90 G0 C90.
G254
#100=1
M30
%
(EXPECT ALARM 10 AT 6)
(EXPECT #100 = 0)
